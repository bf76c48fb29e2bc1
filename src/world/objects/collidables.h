// SPDX-License-Identifier: MIT
// collidables.h -- keeps the slots of collidables, their lists by body, and their kinds.
#ifndef COLLIDABLES_H
#define COLLIDABLES_H
#include "world/world.h"

// Reserves memory for more collidables, so that collidable_put cannot fail. The caller must also call edits_reserve.
scree_status collidables_reserve(scree_world* world, const char* function, int more);

// Allocates slots. On entry slots[k] is the kind of collidable k (KIND_*); on return it is its slot. Inserts a leaf for
// each collidable whose kind is not KIND_DEAD. On failure, no slot is allocated.
scree_status collidables_allocate(scree_world* world, int* slots, int count);

// Creates a collidable in a slot, and appends it to the list of its body, if it has one.
void collidable_put(scree_world* world, int index, const HostCollidable* made);
void collidable_remove(scree_world* world, int index);

// Marks the tree of a collidable for an update, because its box will change; no effect if its body is disabled.
scree_status collidable_mark_tree(scree_world* world, int index);

int collidable_kind(const scree_world* world, int index); // kind; KIND_DEAD if destroyed, or if its body is disabled
int device_kind(const scree_world* world, int index);     // kind as stored on the device, with KIND_SENSOR for a sensor
int kind_on_body(const scree_world* world, int body);     // kind of a collidable on a body; body: -1 for no body
int kind_of_type(scree_body_type type);

static inline int tree_of_kind(int kind) { return kind == KIND_STATIC; }

// Returns whether a collidable is alive, its body is enabled, and it belongs to tree t (0: moving, 1: static).
static inline bool collidable_in_tree(const scree_world* world, int index, int t)
{
	int kind = collidable_kind(world, index);
	return kind != KIND_DEAD && tree_of_kind(kind) == t;
}

#endif
