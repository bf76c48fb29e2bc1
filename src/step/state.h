// SPDX-License-Identifier: MIT
// state.h -- what a step is asked for, and what the host keeps from one step to the next.
#ifndef STEP_STATE_H
#define STEP_STATE_H
#include "backend/backend.h"
#include "backend/runs.h"

typedef struct // host side of one tree of the broad phase; tree.c
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

typedef struct // that a step applies, a group of commands each: before it, after it, or instead of that where it was refused
{
	const Command *begin, *end, *undo;
	const int* groups; // and the end
	int count;
} StepCommands;

typedef struct // what a step is asked for
{
	float dt; // s; 0 for a step that finds contacts and moves nothing
	int substeps;
	scree_vec gravity;
	scree_tuning tuning;
	int bodies, collidables; // slots in use
	int contact_limit;       // 0 for the default
	StepCommands commands;
	bool timings;
} StepRequest;

typedef struct
{
	Backend* backend;
	Counters counters;  // as read back in the last step
	TreeState trees[2]; // what moves; what is static
	uint8_t* member;    // of each collidable slot; tree.c
	int member_capacity;
	RunList list;
	Step step;                    // constants of the last step: kernels that need none keep those
	int used[PER_COUNT];          // most items that a kind of pool needed since idle was 0
	int first_contacts;           // slots of contacts that the pools begin with
	int idle;                     // steps since pools were last looked at for room to give back
	int sparse;                   // steps with few contacts for their slots
	bool jumps;                   // the user placed or made something since the last step: boxes may jump
	bool mixed;                   // some collidable got another attribute of its shape since the last step
	bool begun;                   // the step at work has changed something on the device
	bool rare;                    // some attribute has restitution, rolling resistance or tangent speed
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

#endif
