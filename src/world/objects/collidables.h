// SPDX-License-Identifier: MIT
// collidables.h -- slots of collidables, their lists by body, and their kinds.
#ifndef COLLIDABLES_H
#define COLLIDABLES_H
#include "world/world.h"

// Reserves memory for more collidables, after which collidable_put cannot fail. The caller calls edits_reserve.
scree_status collidables_reserve(scree_world* world, const char* function, int more);

// Takes a slot for each kind in slots, and writes it there; with a leaf unless KIND_DEAD. On failure takes none.
scree_status collidables_allocate(scree_world* world, int* slots, int count);

// Creates a collidable in a slot, at the end of its body's list (body -1: none).
void collidable_put(scree_world* world, int index, const HostCollidable* made);
void collidable_remove(scree_world* world, int index);

int collidable_kind(const scree_world* world, int index); // KIND_DEAD also on a disabled body
int device_kind(const scree_world* world, int index);     // the same with KIND_SENSOR, as stored on the device
int kind_on_body(const scree_world* world, int body);     // kind of a collidable on this body, -1 for none
int kind_of_type(scree_body_type type);

static inline int tree_of_kind(int kind) { return kind == KIND_STATIC; }

#endif
