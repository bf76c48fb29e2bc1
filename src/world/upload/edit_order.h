// SPDX-License-Identifier: MIT
// edit_order.h -- sorts rows by slot, and finds sequences of rows with neighboring slots.
#ifndef EDIT_ORDER_H
#define EDIT_ORDER_H
#include "world/world.h"

scree_status edits_sort(scree_world* world);

// Return the end of the rows with consecutive slots that begin at row k. Rows of collidables are all dead or all alive.
int body_run(const Edits* p, int k);
int collidable_run(const scree_world* world, int k);

// Returns whether the collidable of row k is destroyed or disabled. Only the kind of such a row is uploaded. Then the
// box of the collidable becomes empty, which ends its contacts.
bool edit_is_dead(const scree_world* world, int k);

#endif
