// SPDX-License-Identifier: MIT
// edit_order.h -- sorts rows by slot, and finds sequences of rows with neighboring slots.
#ifndef EDIT_ORDER_H
#define EDIT_ORDER_H
#include "world/world.h"

scree_status edits_sort(scree_world* world);

// Return the end (last row + 1) of rows from row k on with consecutive slots; collidables are all dead or all alive.
int body_run(const Edits* p, int k);
int collidable_run(const scree_world* world, int k);

// Returns whether the collidable of row k is destroyed or disabled. In a long sequence only its kind is uploaded,
// otherwise kind and filter. Then its box becomes empty, which ends its contacts.
bool edit_is_dead(const scree_world* world, int k);

#endif
