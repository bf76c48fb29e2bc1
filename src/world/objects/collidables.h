// SPDX-License-Identifier: MIT
// collidables.h -- slots of collidables, their lists by body, and their kinds.
#ifndef COLLIDABLES_H
#define COLLIDABLES_H
#include "world/world.h"

// Room for so many more, after which collidable_put cannot fail. The caller calls edits_reserve.
scree_status collidables_reserve(scree_world* world, const char* function, int more);

// Takes count slots, with leaves in the trees except for KIND_DEAD. slots holds the kinds (KIND_*) before the call and the
// slots after it. On failure no slot is taken.
scree_status collidables_allocate(scree_world* world, int* slots, int count);

// Makes a collidable in a slot, last in its body's list (body -1: none).
void collidable_put(scree_world* world, int index, const HostCollidable* made);
// Takes a collidable out of its body's list and frees its slot.
void collidable_remove(scree_world* world, int index);

int collidable_kind(const scree_world* world, int index); // KIND_DEAD also on a disabled body
int device_kind(const scree_world* world, int index);     // the same with KIND_SENSOR, as the device has it
int kind_on_body(const scree_world* world, int body);     // of a collidable of this body, -1 for none
int kind_of_type(scree_body_type type);

// The tree for collidables of a kind.
static inline int tree_of_kind(int kind) { return kind == KIND_STATIC; }

#endif
