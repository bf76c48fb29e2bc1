// SPDX-License-Identifier: MIT
// run_call.h -- one call of a program on one world.
#ifndef RUN_CALL_H
#define RUN_CALL_H
#include "programs/program.h"
#include "tools/common/byte_hash.h"

// numbers that a program may give out
#define MOST_NAMES 8192

typedef struct // touches and visits that began and have not ended: how many, and a sum of their names
{
	int count;
	uint64_t sum;
} Open;

struct Names
{
	scree_body bodies[MOST_NAMES];
	scree_collidable collidables[MOST_NAMES];
	scree_attribute attributes[MOST_NAMES];
	scree_joint joints[MOST_NAMES];
	scree_path paths[MOST_NAMES];
	scree_field fields[MOST_NAMES];
	Open open;
};

typedef struct // outcome of a call
{
	scree_status status;
	uint64_t word; // hash of the data that it read
	char error[256];
} Left;

typedef struct // a call on one of the two worlds
{
	const Call* call;
	scree_world* world;
	struct Names* names;
	const Place* place;
	const char* home; // device on which the world was made
	Left* left;
} CallRun;

// arguments of a call
float call_real(const CallRun* run, const char* name);
int call_whole(const CallRun* run, const char* name); // 0 for what is no number that counts
scree_vec call_vec(const CallRun* run, const char* x, const char* y);
scree_pose call_pose(const CallRun* run); // x, y, angle
scree_body call_body(const CallRun* run, int k);

#define MOST_BATCH 256
// Returns the number of names of a batch that begins with the name in an argument; 0 if not all of them can be names.
int call_batch(const CallRun* run, const char* first);

// run_joint.c: the calls of joints, and what can be read of them, mixed into a word.
scree_status run_joint(const CallRun* run);
scree_status read_joints(const CallRun* run, uint64_t* word);

// run_path.c: the same of paths; and all of them destroyed.
scree_path call_path(const CallRun* run);
scree_status run_path(const CallRun* run);
scree_status read_paths(const CallRun* run, uint64_t* word);
scree_status clear_paths(const CallRun* run);

// run_field.c: the same of fields.
scree_status run_field(const CallRun* run);
scree_status read_fields(const CallRun* run, uint64_t* word);
scree_status clear_fields(const CallRun* run);

// run_query.c: queries, with their answers mixed into a word.
scree_status run_ask(const CallRun* run);
scree_status run_blast(const CallRun* run);

// run_step.c: a step, with its events mixed into a word.
scree_status run_step(const CallRun* run);

// The next of a row of numbers (Donald Knuth, H. W. Lewis). Saved programs mean worlds made of these, so it is not that of
// tools/common/random_numbers.h.
uint32_t call_random(uint32_t* seed);
float call_random_part(uint32_t* seed); // from 0 to 1

// Makes the call and returns its status; left gets what it read.
scree_status run_call(const CallRun* run);

// Makes the world that a program begins with.
scree_status run_world(const Place* place, const Call* call, scree_world** world);

#endif
