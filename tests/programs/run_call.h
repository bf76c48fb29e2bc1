// SPDX-License-Identifier: MIT
// run_call.h -- makes one call of a program on one world.
#ifndef RUN_CALL_H
#define RUN_CALL_H
#include "programs/program.h"
#include "tools/common/byte_hash.h"

// Maximum number of names that a program can use for objects of one type.
#define MOST_NAMES 8192

typedef struct // number of touches and visits that have begun and not ended, and the sum of their hashes
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
	void* saved; // the last snapshot, or null
	size_t saved_size;
	Open saved_open; // `open` when the snapshot was taken
	bool rolls;      // the last load was that of a save, not of a snapshot
};

typedef struct // outcome of a call
{
	scree_status status;
	uint64_t word; // hash of the data that the call read
	char error[256];
} Left;

typedef struct // call on one of the two worlds
{
	const Call* call;
	scree_world* world;
	struct Names* names;
	const Place* place;
	const char* home; // device on which the world was created
	Left* left;
} CallRun;

// Each function reads arguments of a call, and returns their value or the object that they name.
float call_real(const CallRun* run, const char* name);
int call_whole(const CallRun* run, const char* name); // 0 if the value is NaN or is not between -1e6 and 1e6
scree_vec call_vec(const CallRun* run, const char* x, const char* y);
scree_pose call_pose(const CallRun* run); // made from the arguments x, y and angle
scree_body call_body(const CallRun* run, int k);
scree_attribute call_attribute(const CallRun* run, const char* name);
scree_filter call_filter(const CallRun* run);
scree_collidable call_collidable(const CallRun* run); // found by its number, or by its position in the list of a body

#define MOST_BATCH 256
// Returns the number of objects of a batch; first: name of the argument with the first number. Returns 0 if a number is
// out of range.
int call_batch(const CallRun* run, const char* first);

// run_attribute.c, run_body.c, run_collidable.c: make the calls of these objects.
scree_status run_attribute(const CallRun* run);
scree_status run_body(const CallRun* run);
scree_status run_collidable(const CallRun* run);

// run_own.c: makes calls of own shapes and surfaces. call_surface returns a definition with a shape and the arguments of SURFACE.
scree_status run_own(const CallRun* run);
scree_attribute_def call_surface(const CallRun* run, scree_shape shape);

// run_joint.c: makes calls of joints. read_joints mixes the state of all joints into a word.
scree_status run_joint(const CallRun* run);
scree_status read_joints(const CallRun* run, uint64_t* word);

// run_path.c: likewise for paths. clear_paths destroys all paths.
scree_path call_path(const CallRun* run);
scree_status run_path(const CallRun* run);
scree_status read_paths(const CallRun* run, uint64_t* word);
scree_status clear_paths(const CallRun* run);

// run_field.c: likewise for fields.
scree_status run_field(const CallRun* run);
scree_status read_fields(const CallRun* run, uint64_t* word);
scree_status clear_fields(const CallRun* run);

// run_sleep.c: makes calls of sleep. read_sleep mixes the states of all bodies, and the definition of one body, into a
// word.
scree_status run_sleep(const CallRun* run);
scree_status read_sleep(const CallRun* run, scree_body body, uint64_t* word);

// read_drawing.c: mixes a drawing of the whole world into a word.
scree_status read_drawing(const CallRun* run, uint64_t* word);

// run_query.c: makes queries and blasts, moves movers, and mixes their results into a word.
scree_status run_ask(const CallRun* run);
scree_status run_blast(const CallRun* run);
scree_status run_walk(const CallRun* run);

// run_step.c: takes a step, and mixes its events into a word. mix_user and mix_contact mix user data of two objects and
// the members of a contact. Structs with 64-bit members are mixed by members: their padding depends on the platform.
scree_status run_step(const CallRun* run);
uint64_t mix_user(uint64_t word, uint64_t a, uint64_t b);
uint64_t mix_contact(uint64_t word, const scree_contact* contact);

// run_batch.c: copies a world into a batch, and returns whether the copies go on with the same bits. Adds 1 to *made if the
// world can be copied.
bool batch_repeat(scree_world* world, const Place* place, int* made);

// run_snapshot.c: takes and restores snapshots. names_clear forgets all names and the snapshot. snapshot_repeat replaces a
// world by its snapshot, with or without a step before; this changes no result of later calls.
scree_status run_save(const CallRun* run);
scree_status run_load(const CallRun* run);
void names_clear(struct Names* names);
void snapshot_repeat(scree_world* world, bool steps);

// recorded.c: begins a recording of a program on the reference, and ends it and repeats it on the other device, if pair->records
// is set.
void recorded_begin(Pair* pair);
void recorded_end(Pair* pair, Outcome* outcome);

// Returns the next number of a random sequence (Donald Knuth, H. W. Lewis). Worlds of saved programs depend on it, so
// tools/common/random_numbers.h cannot replace it.
uint32_t call_random(uint32_t* seed);
float call_random_part(uint32_t* seed); // from 0 to 1

// Makes the call and returns its status. run->left gets the data that the call read.
scree_status run_call(const CallRun* run);

// Creates the world of a program. call: the first call of the program, which contains the settings.
scree_status run_world(const Place* place, const Call* call, scree_world** world);
#define FAULTY_INTERVAL 3 // steps from one kept state to the next, in a place with faults

#endif
