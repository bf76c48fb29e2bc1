// SPDX-License-Identifier: MIT
// bay_layout.h -- lays out the worlds of a batch in pools, copies worlds from bay to bay, and computes their hashes.
#ifndef BAY_LAYOUT_H
#define BAY_LAYOUT_H
#include "step/pipeline_state.h"

#define MOST_BAY_ITEMS (1 << 12) // maximum number of items of a kind in a bay

typedef struct // numbers of bays, and of the items of each
{
	int worlds, spares; // bays for worlds, all of them live at first; bays that are never stepped, numbered after them
	int bodies, collidables, contacts, joints;
	int touching;      // maximum number of contacts with a color of a world, at first
	int sensors;       // maximum number of sensors of a world
	int contact_limit; // maximum number of contacts of a world, 0 for the default
} BaySizes;

// true: batches begin with as few places for constraints as possible, and copy worlds one by one if these do not suffice, so that
// small ones do what large ones do. Tests set it before a batch is created.
extern bool bays_tight_setting;

// Sets Pipeline.bays, and reserves memory. All slots of contacts and joints are free, all other items are zero. The
// pipeline is open, and has made no step.
scree_status bays_open(Pipeline* pipeline, const BaySizes* sizes);

// Returns the maximum number of contact slots of a bay, so that bays of all worlds can have that many.
int bays_slots_most(const Bays* bays);

// Makes room for at least this number of spare bays. Between two steps.
scree_status bays_spare(Pipeline* pipeline, int spares);

// Copies worlds: for each copy, from bay x to bay y. rows: row of the world of each copy, -1 for none. No bay may occur in
// `copies` as y and a second time. most: of each kind, the maximum number of constraints that the copy of a world has.
scree_status bays_copy(Pipeline* pipeline, const Int2* copies, const int* rows, int count, const int* most);

// Sets the number of live bays, between two steps. Bays that are no longer live contain no world. edits: BAY_COUNT_SPOTS,
// BAY_COUNT_EXCLUDED.
scree_status bays_live(Pipeline* pipeline, int live, int edits);

// Gives each bay at least `contacts` contact slots, in the middle of a step. Sets the members of *step that depend on it.
scree_status bays_grow(Pipeline* pipeline, Step* step, int contacts);

// The same between two steps.
scree_status bays_fit(Pipeline* pipeline, int contacts);

// Executes a kernel over items `begin` to `end` - 1 between steps.
scree_status bays_run(Pipeline* pipeline, int kernel, int begin, int end, int argument);

// Executes runs one after the other between steps.
scree_status bays_run_all(Pipeline* pipeline, const Run* runs, int count);

// Computes the hash of each world, by row, without the data that only the host has.
scree_status bays_hash(Pipeline* pipeline, uint64_t* hashes);

// Finds the visits to sensors of the live bays at the end of the last step.
scree_status bays_visit(Pipeline* pipeline);

// Computes the counters of each world, by row.
scree_status bays_counters(Pipeline* pipeline, BayCounters* counters);

#endif
