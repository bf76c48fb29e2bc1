// SPDX-License-Identifier: MIT
// support.h -- helpers for tests of whole worlds: short functions that build one, and runs compared step by step.
#ifndef SUPPORT_H
#define SUPPORT_H
#include "scree/scree.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define STEP     (1.0f / 60.0f) // s
#define SUBSTEPS 4
#define PI       3.14159265358979

// true in the presets that run a smaller set of tests
bool quick(void);
// Skips a test that takes long in quick builds, which look for faults of memory and threads; release runs it, with the same bits.
void skip_if_quick(void);

// Fails the test with the sentence of scree_error.
#define OK(call) check_ok((call), #call, __FILE__, __LINE__)
void check_ok(scree_status status, const char* call, const char* file, int line);

// Fails unless value is within tolerance of expected; NaN fails.
#define NEAR(value, expected, tolerance) check_near((value), (expected), (tolerance), #value, __FILE__, __LINE__)
void check_near(double value, double expected, double tolerance, const char* what, const char* file, int line);

// From here on the library takes its memory from an allocator that fails when none is left; a negative number is as many
// as you like, and what it is set to.
void count_allocations(void);
extern int allocations_left;

// The call with this status must have failed for lack of memory, and said so. From here on there is memory again.
void end_of_shortage(scree_status status);

// the same numbers for every compiler and machine
uint64_t random_word(uint64_t* seed);
float random_between(uint64_t* seed, float low, float high);
int random_below(uint64_t* seed, int count);

// Adds bytes to a hash that began with HASH_BEGIN (Fowler, Noll, Vo).
#define HASH_BEGIN 0xcbf29ce484222325u
uint64_t hash_more(uint64_t hash, const void* bytes, size_t count);

// ---------------------------------------------------------------------------------------------------------------
// worlds on the CPU
// ---------------------------------------------------------------------------------------------------------------

scree_world* open_world(float gravity_y);
// Set-up and tear-down of tests that count the warnings of the log: how many, and the last sentence.
extern int warnings;
extern char warning[256];
int set_warnings(void** state);
int reset_warnings(void** state);

void run_steps(scree_world* world, int steps); // takes steps of STEP in SUBSTEPS

// an attribute of this shape with the default surface, made other by the members that a test sets
scree_attribute_def surface_of(scree_shape shape);
scree_attribute add_attribute(scree_world* world, const scree_attribute_def* def);
scree_shape box_shape(float half_width, float half_height);
scree_shape circle_shape(float radius);

// a body of one collidable at its origin
scree_body add_body(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y,
                    float radians);
scree_body add_box(scree_world* world, scree_body_type type, float half_width, float half_height, float x, float y);
scree_body add_floor(scree_world* world); // a box of 200 by 2 m, its surface at y = 0

scree_vec position_of(scree_world* world, scree_body body);
float angle_of(scree_world* world, scree_body body);
scree_velocity velocity_of(scree_world* world, scree_body body);
uint64_t hash_of(scree_world* world);
scree_counters counters_of(scree_world* world);
float deepest_of(scree_world* world, int steps); // takes steps and returns their deepest overlap, m

typedef struct
{
	double x, y, spin; // sum of m v, and of m r x v + I w about the origin
	double size;       // sum of m |v|
	double energy;     // J, kinetic
} Momentum;

Momentum momentum_of(scree_world* world, const scree_body* bodies, int count);

// Reads all contacts into *contacts, which the caller frees; returns how many.
int read_contacts(scree_world* world, scree_contact** contacts);

// Fails when a pose or a velocity of some body is not finite.
void check_finite(scree_world* world);

// ---------------------------------------------------------------------------------------------------------------
// the same run on many devices
// ---------------------------------------------------------------------------------------------------------------

typedef struct // device and settings of a world
{
	char name[160];
	char device[128];
	int threads, lanes;
	const char* persistent; // value of the environment's SCREE_PERSISTENT; null leaves it
	const char* solver;     // the same for SCREE_SOLVER
	char other[128];        // the device to which the world moves now and then, and back; empty for none
} Way;

#define MAX_WAYS 32

// The first is the reference: one thread, one lane. Then every number of lanes that the processor has with one thread
// and with two, and every OpenCL device that keeps equal bits, with its solver in each of its forms. Then a world
// that moves between the CPU and each of these devices.
int list_ways(Way ways[MAX_WAYS]);
void print_ways(const Way* ways, int count);

// Creates a world there; of def all but device, threads and lanes counts.
scree_world* open_on(const Way* way, const scree_world_def* def);

typedef struct // a run that can be repeated
{
	const char* name;
	scree_world_def def; // device, threads and lanes follow the way
	float dt;
	int substeps, steps;
	void (*build)(scree_world* world, const void* context);
	void (*act)(scree_world* world, int step, const void* context); // before each step; may be null
	const void* context;
} Story;

// Runs a story and writes the hash after each step; last gets the counters of the end, unless it is null.
void tell(const Story* story, const Way* way, uint64_t* hashes, scree_counters* last);

// Whether way k is taken in a turn. In quick builds, which look for faults of the host's code, the OpenCL ways take turns.
bool way_has_turn(const Way* ways, int count, int k, int turn);

// Runs a story on every way and fails unless all hashes of all steps are equal. The failure names the first step that
// differs and the pools that do. Returns the last hash; last gets the counters of the reference, unless it is null.
uint64_t check_parity(const Story* story, const Way* ways, int count, scree_counters* last);

// The same for two stories on one way, which may differ in what must make no difference.
void check_same(const Story* a, const Story* b, const Way* way);

// Prints the names of the pools in which two worlds differ, with the first item.
void print_different_pools(scree_world* a, scree_world* b);

#endif
