// SPDX-License-Identifier: MIT
// edit_order.h -- sorts rows by slot, and finds sequences of rows with neighboring slots.
#ifndef EDIT_ORDER_H
#define EDIT_ORDER_H
#include "world/world.h"

scree_status edits_sort(scree_world* world);

// Return the end of the rows with neighboring slots that begin at row k. Their collidables are all dead or all alive.
int body_run(const Edits* p, int k);
int collidable_run(const scree_world* world, int k);

// Returns whether the collidable of row k is destroyed or disabled. Such a row has only its kind written, and its box
// becomes empty, which ends the contacts.
bool edit_is_dead(const scree_world* world, int k);

#endif
