// SPDX-License-Identifier: MIT
// import.h -- copies a world to the pools of the paper's pipeline.
#ifndef IMPORT_H
#define IMPORT_H
#include "tools/paper/paper_state.h"

// Copies the bodies, collidables, attributes and gravity of a world.
scree_status paper_import(Paper* paper, scree_world* world);

#endif
