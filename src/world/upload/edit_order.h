// SPDX-License-Identifier: MIT
// edit_order.h -- sorts rows by slot, and finds their runs.
#ifndef EDIT_ORDER_H
#define EDIT_ORDER_H
#include "world/world.h"

scree_status edits_sort(scree_world* world);

// Return the end of the run of neighboring slots that begins at row k; its collidables are all dead or all alive.
int body_run(const Edits* p, int k);
int collidable_run(const scree_world* world, int k);

// Returns whether row k's collidable is destroyed or disabled: only its kind is written; its empty box ends contacts.
bool edit_is_dead(const scree_world* world, int k);

#endif
