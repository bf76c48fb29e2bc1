// SPDX-License-Identifier: MIT
// program.h -- random programs of calls on a world: made, written down, run on two worlds side by side, shrunk.
#ifndef PROGRAM_H
#define PROGRAM_H
#include "backend/tables.h"
#include "scree/scree.h"
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define SURFACE "density=1 friction=0.6 restitution=0 rolling=0 tangent=0 way_x=0 way_y=0 material=0"
#define FILTER  "category=1 mask=-1 group=0"
#define COORDINATE                                                                                                \
	"target=0 lock_hertz=0 lock_ratio=0 lower=0 upper=0 spring_hertz=0 spring_ratio=0 spring_max=1e30 push=1e30 " \
	"pull=1e30 speed=0 motor_max=0"

typedef enum
{
#define X(name, arguments) CALL_##name,
#include "programs/calls.def"
#undef X
	CALL_KINDS
} CallKind;

#define MOST_ARGUMENTS 24

typedef struct
{
	CallKind kind;
	float value[MOST_ARGUMENTS]; // in the order of calls.def
} Call;

typedef struct
{
	Call* calls; // the first one is CALL_world
	int count, capacity;
} Program;

typedef struct // line of calls.def for one kind
{
	const char* name;
	int count;
	char names[MOST_ARGUMENTS][16];
	float values[MOST_ARGUMENTS]; // defaults
} CallInfo;

// program.c
const CallInfo* call_info(CallKind kind);
Call call_make(CallKind kind);                            // all arguments as calls.def has them
float call_value(const Call* call, const char* name);     // value of an argument that the call has
void call_set(Call* call, const char* name, float value); // the same
void program_add(Program* program, Call call);
void program_copy(Program* to, const Program* from); // frees the old calls of to
void program_close(Program* program);
void program_write(const Program* program, FILE* file);           // a line a call, what is as in calls.def left out
bool program_read(Program* program, FILE* file, char error[256]); // reads the text of program_write

// make.c: makes a program with a number of calls. Programs of the same block of PROGRAM_BLOCK seeds make the same world.
#define PROGRAM_BLOCK 64
void program_make(Program* program, uint64_t seed, int calls);

typedef struct // device of a world, and the device to which the call "move" takes it; empty for none
{
	char device[128], other[128];
	int threads, lanes;
	bool reads; // between calls, the world is read, and moved to its own device
} Place;

// values of Pair.first_read that are tried: they choose other kinds of reads for the same calls
#define READ_CHOICES 16

typedef struct // two worlds on which programs run one after the other
{
	Place places[2]; // the first is the reference
	scree_world* worlds[2];
	char homes[2][160]; // devices on which they were made
	Call made;          // with which they were made
	struct Names* names[2];
	struct Worker* worker; // makes the reference's steps, or null
	bool infinite;         // state that is not finite is no difference
	bool limits;           // a body beyond the limits of its world is a difference
	bool anew;             // every program gets new worlds
	uint32_t first_read;   // one of READ_CHOICES
	int every;             // steps after which hashes are compared, and at a program's end; 0 is 1
} Pair;

typedef struct
{
	bool differs;
	int call;           // index of the first call after which they differ
	char sentence[256]; // how
	int steps, frozen;  // that were made, and bodies that were frozen in them
} Outcome;

// pair.c
void program_add_empty(Program* program); // calls that leave worlds as they were made, as far as calls can
void pair_open(Pair* pair, const Place places[2]);
void pair_close(Pair* pair);
// Runs a program on both worlds. They are made again unless they are empty and were made with the same call. Differences are
// written to details, unless it is null.
Outcome pair_run(Pair* pair, const Program* program, FILE* details);
void pair_forget(Pair* pair);     // the next program gets new worlds
scree_status pair_hide_log(void); // from here on the library prints nothing

// different.c: the first items of a pool, which the caller frees.
void* read_items(scree_world* world, PoolId pool, int count);
// Prints the fields of the pools in which two worlds differ.
void different_print(scree_world* a, scree_world* b, FILE* file);
// Whether all state of a world is finite; names the first that is not.
bool state_finite(scree_world* world, char sentence[256]);
// Whether no body is faster than max_speed, or turns by more than the last step allowed; names the first that is.
bool state_limited(scree_world* world, char sentence[256]);
// Returns the number of bodies that the last step froze.
int state_frozen(scree_world* world);

// coloring.c: whether colors, counts and hubs fit each other; names the first that does not.
bool state_colored(scree_world* world, char sentence[256]);

// shrink.c: replaces a program by the shortest one found within a number of seconds that differs as well.
void program_shrink(Program* program, Pair* pair, double seconds);

#endif
