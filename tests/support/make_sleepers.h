// SPDX-License-Identifier: MIT
// make_sleepers.h -- makes worlds in which bodies sleep, and checks that a test has the same bits on each device.
#ifndef MAKE_SLEEPERS_H
#define MAKE_SLEEPERS_H
#include "support/make_bodies.h"

#define STACK 4 // number of crates in a stack

// Steps of rest until an island sleeps: 0.5 s are REST_STEPS steps, and islands are searched in every 8th step.
#define REST_STEPS 30
#define MOST_STEPS (REST_STEPS + 1 + 8)

// Opens a world that sleeps on the current device, with a floor whose surface is at y = 0 if there is gravity.
scree_world* open_sleepers(float gravity_y);
// Takes 3 steps and destroys the world. Fails unless its hash is that of the first group of RUN_SLEEPERS.
void close_sleepers(scree_world* world);

// Adds a stack of crates of 1 m, from bottom to top, and returns its bottom.
scree_body add_stack(scree_world* world, float x, scree_body bodies[STACK]);
bool is_awake(scree_world* world, scree_body body);
void expect_awake(scree_world* world, const scree_body* bodies, int count, bool awake);
// Takes steps until all bodies sleep; fails if they do not within 200 steps.
void run_to_sleep(scree_world* world, const scree_body* bodies, int count);
// Takes steps while bodies stay as they are, awake or asleep. Fails if one changes.
void run_as_before(scree_world* world, const scree_body* bodies, int count, int steps, bool awake);

int use_one_thread(void** state);
int use_three_threads(void** state);
int use_sleepers_on_opencl(void** state);

// Runs tests on the CPU with one thread and one lane, on the CPU with 3 threads and all lanes, and on OpenCL.
#define RUN_SLEEPERS(tests)                                                                          \
	(cmocka_run_group_tests_name("1 thread, 1 lane", tests, use_one_thread, memory_is_released) +    \
	 cmocka_run_group_tests_name("3 threads", tests, use_three_threads, memory_is_released) +        \
	 (scree_opencl_hint()[0] == '\0'                                                                 \
	      ? cmocka_run_group_tests_name("opencl", tests, use_sleepers_on_opencl, memory_is_released) \
	      : 0))

#endif
