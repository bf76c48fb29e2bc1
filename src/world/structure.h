// SPDX-License-Identifier: MIT
// structure.h -- notes changes of the structure of a world: the data that only calls of the user change, never a step.
#ifndef STRUCTURE_H
#define STRUCTURE_H
#include "scree/scree.h"

// Gives the structure of a world a new version, so that the next save copies it.
void structure_changed(scree_world* world);

// The same if some pending edit changes the structure. To be called before each upload.
void structure_note(scree_world* world);

#endif
