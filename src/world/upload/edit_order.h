// SPDX-License-Identifier: MIT
// edit_order.h -- sorts rows by slot, and finds their runs.
#ifndef EDIT_ORDER_H
#define EDIT_ORDER_H
#include "world/world.h"

// Sorts the rows of bodies and of collidables by slot.
scree_status edits_sort(scree_world* world);

// Return the end of the run of neighboring slots that begins at row k. The collidables of a run are all dead or all
// alive.
int body_run(const Edits* p, int k);
int collidable_run(const scree_world* world, int k);

// Returns whether the collidable of row k was destroyed, or its body is disabled. Only the kind of a dead one is
// written: its contacts end when they find its box empty.
bool edit_is_dead(const scree_world* world, int k);

#endif
