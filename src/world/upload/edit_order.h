// SPDX-License-Identifier: MIT
// edit_order.h -- rows in the order of their slots, and their runs.
#ifndef EDIT_ORDER_H
#define EDIT_ORDER_H
#include "world/world.h"

// Sorts the rows of bodies and of collidables by their slots.
scree_status edits_sort(scree_world* world);

// The end of the run of neighboring slots that begins at row k. A run of collidables is all dead or all alive.
int body_run(const Edits* p, int k);
int collidable_run(const scree_world* world, int k);

// Whether the collidable of row k was destroyed, or its body is disabled. Only the kind of a dead one is written: its contacts
// end when they find its box empty.
bool edit_is_dead(const scree_world* world, int k);

#endif
