// SPDX-License-Identifier: MIT
// program.h -- random programs of calls on a world: makes, writes and reads them, runs them on two worlds side by side,
// and shortens them.
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
	float value[MOST_ARGUMENTS]; // values of the arguments, in the order of calls.def
} Call;

typedef struct
{
	Call* calls; // the first call is CALL_world
	int count, capacity;
} Program;

typedef struct // one line of calls.def
{
	const char* name;
	int count;
	char names[MOST_ARGUMENTS][16];
	float values[MOST_ARGUMENTS]; // default values
} CallInfo;

// defined in program.c
const CallInfo* call_info(CallKind kind);
Call call_make(CallKind kind);                            // returns a call with the default arguments of calls.def
float call_value(const Call* call, const char* name);     // returns the value of an argument
void call_set(Call* call, const char* name, float value); // sets an argument
void program_add(Program* program, Call call);
void program_copy(Program* to, const Program* from); // replaces the program `to`
void program_close(Program* program);
void program_write(const Program* program, FILE* file); // one line per call; arguments with defaults are left out
bool program_read(Program* program, FILE* file, char error[256]); // reads the text of program_write

// make.c: makes a program with a number of calls. Programs of a block of PROGRAM_BLOCK seeds begin with the same world.
#define PROGRAM_BLOCK 64
void program_make(Program* program, uint64_t seed, int calls);
// Makes a program from the bytes of a fuzzer, also with wild values and forged handles, until it has that many calls or the
// bytes end.
void program_make_from(Program* program, const uint8_t* bytes, size_t size, int calls);

typedef struct // first device of a world, and device to which the call "move" moves it; empty: no such device
{
	char device[128], other[128];
	int threads, lanes;
	bool flush; // true: its devices flush denormals to 0 (backend/arithmetic.h)
	// true: between calls the world is read, and moved to the device that it is on; it skips no steps in which nothing
	// moves
	bool reads;
	// true: after each step the world is copied into a batch (run_batch.c)
	bool batches;
	// true: between calls its devices fail, and it recovers; a CPU counts as a device that fails
	bool faults;
} Place;

// number of values of Pair.first_read; each value selects other reads for the same calls
#define READ_CHOICES 16

typedef struct // two worlds on which programs run one after another
{
	Place places[2]; // places[0]: place of the reference
	scree_world* worlds[2];
	char homes[2][160]; // devices on which the worlds were created
	Call made;          // the call that created the worlds
	struct Names* names[2];
	// They keep the contexts on a GPU open while a program has no world and no batch there; null: the CPU, no batches.
	scree_world* keeper;
	scree_batch* batch_keeper;
	struct Worker* worker; // thread that takes the steps of the reference; null: no such thread
	bool infinite;         // true: a state that is not finite is not reported
	bool limits;           // true: a body beyond the limits of its world is reported
	bool anew;             // true: each program gets new worlds
	// true: the calls on the reference are recorded, and repeated on the other device at the end of the program (recorded.c)
	bool records;
	const char* record_path; // file to which the last recording is written; null: none
	scree_world* repeated;   // world of the replays
	int batches;             // number of times that a world was copied into a batch
	uint32_t first_read;     // selects the reads between the calls; from 0 to READ_CHOICES - 1
	int every; // steps from one comparison of hashes to the next; the end of a program is also compared; 0 means 1
} Pair;

typedef struct
{
	bool differs;
	int call;           // index of the first call after which the worlds differ
	char sentence[256]; // description of the difference
	int steps, frozen;  // number of steps; number of bodies that were frozen in these steps
	int batches;        // number of batches that were made
	int slept, woke;    // number of times that a body fell asleep, and that a body woke
	uint64_t hash;      // hash of the results of all calls; equal on every platform
} Outcome;

// defined in pair.c
void program_add_empty(Program* program); // adds calls that return a world to its first state, as far as calls can
void pair_open(Pair* pair, const Place places[2]);
void pair_close(Pair* pair);
// Runs a program on both worlds. The worlds are reused if they were created by the same call and can be emptied;
// otherwise new worlds are created. details: receives the differences; may be null.
Outcome pair_run(Pair* pair, const Program* program, FILE* details);
void pair_forget(Pair* pair);     // gives new worlds to the next program
scree_status pair_hide_log(void); // turns off the log of the library
// run_batch.c: creates a batch of an empty world, which keeps the context of batches on a GPU open.
scree_status batch_keep(const char* device, scree_batch** batch);

// different.c: reads the first `count` items of a pool. The caller frees the items.
void* read_items(scree_world* world, PoolId pool, int count);
// Prints the fields of the pools in which two worlds differ.
void different_print(scree_world* a, scree_world* b, FILE* file);
// Returns whether all state of a world is finite. If not, sentence gets the first value that is not finite.
bool state_finite(scree_world* world, char sentence[256]);
// Returns whether no body exceeds max_speed or the spin that the last step allowed. If not, sentence gets the first
// such body.
bool state_limited(scree_world* world, char sentence[256]);
// Returns the number of bodies that the last step froze.
int state_frozen(scree_world* world);

// count_sleep.c: counts bodies that fall asleep and wake.
typedef struct
{
	scree_body* sleepers; // per slot: the body that slept there after the last step, or null
	int slots;
} Sleepers;
// Adds the numbers of bodies that fell asleep, and that woke, since the last call.
void sleepers_count(Sleepers* sleepers, scree_world* world, int* slept, int* woke);
void sleepers_close(Sleepers* sleepers);

// check_sleep.c: returns whether joined bodies sleep together, and the constraints of awake bodies only are solved. If
// not, sentence gets the first fault.
bool state_sleeps(scree_world* world, char sentence[256]);

// coloring.c: returns whether colors, counts and hubs are consistent. If not, sentence gets the first fault.
bool state_colored(scree_world* world, char sentence[256]);

// shrink.c: replaces a program by the shortest program found after which the worlds also differ. seconds: limit of
// time.
void program_shrink(Program* program, Pair* pair, double seconds);

#endif
