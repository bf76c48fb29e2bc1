// SPDX-License-Identifier: MIT
// make_worlds.h -- creates worlds for tests, steps them, and reads their state.
#ifndef MAKE_WORLDS_H
#define MAKE_WORLDS_H
#include "platform/trig.h" // declares PI
#include "support/checks.h"

#define STEP     (1.0f / 60.0f) // length of a step, s
#define SUBSTEPS 4
#define H        (1.0 / 60.0 / SUBSTEPS) // length of a substep, s
#define G        10.0                    // gravity, m/s^2

scree_world* create_world(const scree_world_def* def);

// Opens a world. Settings that are not parameters have their defaults. threads: 0 means one thread per core.
scree_world* open_world_on(const char* device, int threads, float gravity_y);
scree_world* open_world(float gravity_y);      // opens a world on the CPU with one thread
scree_world* open_test_world(float gravity_y); // opens a world on the device test_device, with two threads
extern const char* test_device;                // device that RUN_ON_DEVICES sets
scree_world* stay_awake(scree_world* world);   // turns sleep off, for tests of motions that end; returns the world

void run_steps(scree_world* world, int steps);   // takes steps of length STEP with SUBSTEPS substeps
void update_contacts(scree_world* world);        // takes a step of 0 s, in which nothing moves
float deepest_of(scree_world* world, int steps); // takes steps; returns the deepest overlap in any of them, m

uint64_t hash_of(scree_world* world);
scree_counters counters_of(scree_world* world);
scree_events events_of(scree_world* world);
int contacts_of(scree_world* world);
int contacts_with(scree_world* world, scree_body body);

// Reads all contacts into a new array *contacts, which the caller frees. Returns the number of contacts.
int read_contacts(scree_world* world, scree_contact** contacts);

// Fails if the pose or the velocity of any body is not finite.
void check_finite(scree_world* world);

int use_cpu(void** state);
int use_opencl(void** state);

// Runs tests, an array of CMUnitTest, on the CPU and, if there is a device, on OpenCL. Returns the number of failures.
#define RUN_ON_DEVICES(tests)                                                                                       \
	(cmocka_run_group_tests_name("cpu", tests, use_cpu, memory_is_released) +                                       \
	 (scree_opencl_hint()[0] == '\0' ? cmocka_run_group_tests_name("opencl", tests, use_opencl, memory_is_released) \
	                                 : 0))

#endif
