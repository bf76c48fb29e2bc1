// SPDX-License-Identifier: MIT
// reserve.h -- sets the capacities of the pools: enlarges them for a stage, and shrinks those that remain too large.
#ifndef RESERVE_H
#define RESERVE_H
#include "step/pipeline_state.h"

#define LEAST_CAPACITY GROUP_ITEMS // number of items; requested capacities are rounded up to a multiple of this

// For each kind of items in groups (GROUPS_OF_*): the kind of its pools.
extern const Per grouped[GROUP_KINDS];

// Returns a number of items, rounded up to whole groups.
static inline int group_items(int items) { return (items + GROUP_ITEMS - 1) / GROUP_ITEMS * GROUP_ITEMS; }

// Returns the larger number of groups that the pools of bodies and of collidables have.
int groups_most(const Backend* b);

// Returns the number of places for constraints, whose colors are padded.
int64_t places_of(int64_t constraints);

// Ensures space for `capacity` items in the pools of `per` and in pools that depend on them; pools grow by half or more, those of a
// batch by a quarter.
scree_status pipeline_reserve(Pipeline* pipeline, Per per, int capacity);

// Shrinks pools that have been much too large for a long time. Must be called after each step. Fails only if the device
// fails.
scree_status pipeline_trim(Pipeline* pipeline);

// Returns whether most contact slots have been unused in many consecutive steps. Must be called once per step.
bool pipeline_sparse(Pipeline* pipeline);

#endif
