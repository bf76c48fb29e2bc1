// SPDX-License-Identifier: MIT
// bay_layout.h -- lays out the worlds of a batch in pools, copies worlds from bay to bay, and computes their hashes.
#ifndef BAY_LAYOUT_H
#define BAY_LAYOUT_H
#include "step/pipeline_state.h"

#define MOST_BAY_ITEMS (1 << 12) // maximum number of items of a kind in a bay

typedef struct // numbers of bays, and of the items of each
{
	int worlds, spares; // bays that are stepped; other bays, numbered after them
	int bodies, collidables, contacts, joints;
} BaySizes;

// Sets Pipeline.bays, and reserves memory. All slots of contacts and joints are free, all other items are zero. The
// pipeline is open, and has made no step.
scree_status bays_open(Pipeline* pipeline, const BaySizes* sizes);

// Copies worlds: for each copy, from bay x to bay y. No bay may occur in `copies` as y and a second time.
scree_status bays_copy(Pipeline* pipeline, const Int2* copies, int count);

// Gives each bay at least `contacts` contact slots, in the middle of a step. Sets the members of *step that depend on it.
scree_status bays_grow(Pipeline* pipeline, Step* step, int contacts);

// Executes a kernel over items `begin` to `end` - 1 between steps.
scree_status bays_run(Pipeline* pipeline, int kernel, int begin, int end, int argument);

// Computes the hash of each live bay, without the data that only the host has.
scree_status bays_hash(Pipeline* pipeline, uint64_t* hashes);

#endif
