// SPDX-License-Identifier: MIT
// touched.h -- ends the rest of groups of items that the user changes, in a world that sleeps.
#ifndef TOUCHED_H
#define TOUCHED_H
#include "scree/scree.h"

// Collects the groups and the collidables of all pending edits. The caller then calls touched_upload, which reads the
// state of these collidables, before it uploads the edits.
scree_status touched_collect(scree_world* world);
scree_status touched_upload(scree_world* world);

#endif
