// SPDX-License-Identifier: MIT
// pipeline.h -- the step, and what it keeps on the host from one step to the next.
#ifndef PIPELINE_H
#define PIPELINE_H
#include "backend.h"

typedef struct // host side of one tree of the broad phase; src/tree.c
{
	Tree tree, sent; // as it is, and as the device has it
	int* added;      // collidables to append to the leaves in the next step
	int added_count, added_capacity;
	int64_t unsorted; // leaves appended, and boxes that changed, since the leaves were last put in order
	double strayed;   // nodes visited in vain since then because of boxes that jumped
	int churned;      // steps in a row in which boxes jumped so far that the leaves were put in order
	bool ordered;     // the step at work puts the leaves in order because boxes will have jumped
	bool touched;     // some box of this tree changed by the user's doing
	int* left; // collidables that were destroyed or went to the other tree since the leaves were last put in order
	int left_count, left_capacity;
	bool shrunk; // there are more of these than left has
} TreeState;

typedef struct // a list under construction
{
	Run* runs;
	int count, capacity;
} RunList;

typedef struct
{
	Counters counters;  // as read back in the last step
	TreeState trees[2]; // what moves; what is static
	uint8_t* member;    // of each collidable slot: bit t when tree t has a leaf for it
	int member_capacity;
	RunList list;
	Step step;                    // constants of the last step: kernels that need none keep those
	int used[PER_COUNT];          // most items that a kind of pool needed since idle was 0
	int idle;                     // steps since pools were last looked at for room to give back
	int sparse;                   // steps with few contacts for their slots
	bool jumps;                   // the user placed or made something since the last step: boxes may jump
	bool mixed;                   // some collidable got another attribute of its shape since the last step
	bool begun;                   // the step at work has changed something on the device
	bool extras;                  // some attribute has restitution, rolling resistance or tangent speed
	bool bounces;                 // some attribute has restitution
	bool round;                   // some attribute has a radius
	float guard_way, guard_reach; // as in Step: bounds of all bodies that there ever were
	bool split;                   // the spokes of the layout know into how many parts their light ends are split
	int rounds;                   // coloring rounds that the last step needed
	int64_t steps;
	int grown;               // times that a pool grew
	double milliseconds;     // of the last step, by the wall clock
	double boxes[BOX_COUNT]; // the same by box; zeros unless timings were asked for
	scree_traffic traffic;   // of the last step
} Pipeline;

// Gives the pools their first sizes. world->backend is open; world->def has the capacities to begin with.
scree_status pipeline_open(scree_world* world);
void pipeline_close(scree_world* world); // releases what the pipeline holds, not the backend

// One step: dt seconds in substeps. world_flush has been called.
scree_status pipeline_step(scree_world* world, float dt, int substeps);

// The hash of all simulated state. world_flush has been called.
scree_status pipeline_hash(scree_world* world, uint64_t* hash);

// Brings the pool shown up to date for all slots of collidables; where it is shared, in the memory that OpenGL draws
// from. world_flush has been called.
scree_status pipeline_show(scree_world* world, bool shared);

// Puts the touching contacts of a body together in the pool listed, and says how many there are. world_flush has been
// called.
scree_status pipeline_list_contacts(scree_world* world, int body, int* count);

// Gives a kind of pool and those that follow it (constraints with contacts, leaves and nodes with collidables, ...)
// room for at least capacity items; grows by half at least.
scree_status pipeline_reserve(scree_world* world, Per per, int capacity);

// places of spokes, padding included
static inline int pipeline_spokes(const Counters* c) { return c->color_begin[COLORS + 1] - c->color_begin[COLORS]; }

// After a step: gives back the room of pools that have long been much too large.
void pipeline_trim(scree_world* world);

// Counts the step; whether contacts have long been few for the slots that they are spread over.
bool pipeline_sparse(scree_world* world);

// Makes sure that tree t (0: moving, 1: static) has a leaf for a collidable. Its row is written by the time of the next
// step.
scree_status tree_insert(scree_world* world, int t, int collidable);
// Takes back the leaf that was inserted last: its slot is free again, and the pools may have no room for it.
void tree_withdraw(scree_world* world, int collidable);
// The box of some collidable of tree t changed by the user's doing.
void tree_touch(scree_world* world, int t);
// The same; the collidable was destroyed, or went to the other tree.
void tree_leave(scree_world* world, int t, int collidable);

#endif
