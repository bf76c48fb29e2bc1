// SPDX-License-Identifier: MIT
// import.h -- fills the pools of the paper's pipeline from a world.
#ifndef IMPORT_H
#define IMPORT_H
#include "tools/paper/paper_state.h"

// Copies bodies, collidables, attributes and gravity of a world into the pools.
scree_status paper_import(Paper* paper, scree_world* world);

#endif
