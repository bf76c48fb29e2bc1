// SPDX-License-Identifier: MIT
// program.h -- random programs of calls on a world: made, written, run on two worlds side by side, and shortened.
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
Call call_make(CallKind kind);                            // all arguments have the defaults of calls.def
float call_value(const Call* call, const char* name);     // value of an argument
void call_set(Call* call, const char* name, float value); // sets an argument
void program_add(Program* program, Call call);
void program_copy(Program* to, const Program* from); // frees the old calls of to
void program_close(Program* program);
void program_write(const Program* program, FILE* file); // one line per call; arguments with defaults are left out
bool program_read(Program* program, FILE* file, char error[256]); // reads the text of program_write

// make.c: makes a program with a number of calls. Programs of a block of PROGRAM_BLOCK seeds begin with the same world.
#define PROGRAM_BLOCK 64
void program_make(Program* program, uint64_t seed, int calls);

typedef struct // device of a world, and the device of the call "move"; empty for none
{
	char device[128], other[128];
	int threads, lanes;
	bool reads; // the world is read between calls, and moved to its own device
} Place;

// number of values of Pair.first_read; each selects other reads for the same calls
#define READ_CHOICES 16

typedef struct // two worlds on which programs run one after the other
{
	Place places[2]; // places[0] is that of the reference
	scree_world* worlds[2];
	char homes[2][160]; // devices on which they were created
	Call made;          // call that created them
	struct Names* names[2];
	struct Worker* worker; // takes the steps of the reference, or null
	bool infinite;         // a state that is not finite is no difference
	bool limits;           // a body beyond the limits of its world is a difference
	bool anew;             // each program gets new worlds
	uint32_t first_read;   // from 0 to READ_CHOICES - 1
	int every; // steps from one comparison of hashes to the next; the end of a program has one too; 0 means 1
} Pair;

typedef struct
{
	bool differs;
	int call;           // index of the first call after which they differ
	char sentence[256]; // description of the difference
	int steps, frozen;  // number of steps, and of bodies that were frozen in them
} Outcome;

// pair.c
void program_add_empty(Program* program); // adds calls that return a world to its first state, as far as calls can
void pair_open(Pair* pair, const Place places[2]);
void pair_close(Pair* pair);
// Runs a program on both worlds. They are created again unless they are empty and were created by the same call.
// details gets the differences, unless it is null.
Outcome pair_run(Pair* pair, const Program* program, FILE* details);
void pair_forget(Pair* pair);     // the next program gets new worlds
scree_status pair_hide_log(void); // turns off the log of the library

// different.c: reads the first items of a pool, which the caller frees.
void* read_items(scree_world* world, PoolId pool, int count);
// Prints the fields of the pools in which two worlds differ.
void different_print(scree_world* a, scree_world* b, FILE* file);
// Returns whether all state of a world is finite. sentence gets the first value that is not.
bool state_finite(scree_world* world, char sentence[256]);
// Returns whether no body exceeds max_speed or the spin that the last step allowed. sentence gets the first that does.
bool state_limited(scree_world* world, char sentence[256]);
// Returns the number of bodies that the last step froze.
int state_frozen(scree_world* world);

// coloring.c: returns whether colors, counts and hubs are consistent. sentence gets the first fault.
bool state_colored(scree_world* world, char sentence[256]);

// shrink.c: replaces a program by the shortest one, found within a number of seconds, that still differs.
void program_shrink(Program* program, Pair* pair, double seconds);

#endif
