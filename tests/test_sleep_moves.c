// SPDX-License-Identifier: MIT
// test_sleep_moves.c -- checks that worlds of sleepers have equal bits on every device, and after moves between devices.
//
// Formula: hash(device, lanes, threads, step) = hash(cpu, 1, 1, step), for each step.
#include "support/make_joints.h"
#include "support/make_sleepers.h"
#include "support/scenarios.h"
#include "support/second_device.h"

#define MOST 64

// Builds 4 stacks, a chain that hangs from a kinematic body, a field, and 16 discs that are created asleep.
static void build(scree_world* world, const void* context)
{
	(void)context;
	scree_body bodies[STACK];
	add_floor(world);
	for (int k = 0; k < 4; ++k)
		add_stack(world, 6.0f * (float)k, bodies);
	scree_body last = add_crate(world, SCREE_BODY_KINEMATIC, -10.0f, 8.0f);
	for (int k = 0; k < 9; ++k)
	{
		scree_body next = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.25f, -10.0f, 7.25f - 0.5f * (float)k);
		join(world, SCREE_JOINT_REVOLUTE, last, next, -10.0f, 7.5f - 0.5f * (float)k);
		last = next;
	}
	scree_body_def def = body_def(SCREE_BODY_DYNAMIC, shape_attribute(world, circle_shape(0.3f)), 0.0f, 12.0f);
	for (int k = 0; k < 16; ++k)
	{
		def.pose.position.x = 2.0f * (float)k;
		def.asleep = true;
		create_body(world, &def);
	}
}

// Wakes and puts to sleep in the 300 steps, so that islands sleep, wake and join.
static void act(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_body bodies[MOST];
	int count;
	OK(scree_world_get_bodies(world, bodies, MOST, &count));
	if (step == 70)
		OK(scree_body_set_awake(world, bodies[count - 16], true)); // a disc falls on the first stack
	if (step == 90)
		OK(scree_world_set_box_awake(world, (scree_box){{17.0f, 0.0f}, {19.0f, 1.0f}}, true));
	if (step == 100)
		OK(scree_body_set_linear_velocity(world, bodies[1 + 4 * STACK], (scree_vec){0.3f, 0.0f}));
	if (step == 130)
		OK(scree_world_set_awake(world, false));
	if (step == 140)
		OK(scree_body_destroy(world, bodies[1 + STACK])); // the lowest crate of the second stack
	if (step == 150)
		OK(scree_body_set_linear_velocity(world, bodies[4 * STACK], (scree_vec){0.0f, 0.0f}));
	if (step == 200)
		OK(scree_world_set_gravity(world, (scree_vec){0.5f, -10.0f}));
	if (step == 290)
		OK(scree_world_set_awake(world, false));
}

static void sleepers_have_equal_bits(void** state)
{
	(void)state;
	Scenario scenario = scenario_of("sleepers", 300, build, act, NULL);
	scree_counters last;
	scenario.def.sleep = true;
	check_parity(&scenario, &last);
	assert_int_equal(last.dynamic_bodies, 4 * STACK + 9 + 16 - 1);
	assert_true(last.asleep_bodies > 0);
}

// A world of sleepers that moves to another device and wakes there has the bits of a world that stayed.
static void moved_sleepers_have_equal_bits(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.sleep = true;
	scree_world* worlds[2];
	scree_body bodies[MOST];
	int count;
	for (int k = 0; k < 2; ++k)
	{
		worlds[k] = create_world(&def);
		build(worlds[k], NULL);
		run_steps(worlds[k], 140);
		assert_true(counters_of(worlds[k]).asleep_bodies >= 4 * STACK + 16);
	}
	assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
	OK(scree_world_move(worlds[1], second_device));
	assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
	int asleep = counters_of(worlds[0]).asleep_bodies;
	assert_int_equal(counters_of(worlds[1]).asleep_bodies, asleep);
	OK(scree_world_get_bodies(worlds[0], bodies, MOST, &count));
	for (int step = 0; step < 80; ++step)
	{
		for (int k = 0; k < 2; ++k)
		{
			if (step == 10)
				OK(scree_body_set_awake(worlds[k], bodies[2], true));
			if (step == 15)
				OK(scree_body_set_awake(worlds[k], bodies[count - 14], true));
			if (step == 60)
				OK(scree_world_set_awake(worlds[k], true));
			run_steps(worlds[k], 1);
		}
		assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
		if (step == 10)
			assert_int_equal(counters_of(worlds[1]).asleep_bodies, asleep - STACK);
	}
	assert_int_equal(counters_of(worlds[1]).asleep_bodies, 0);
	OK(scree_world_move(worlds[1], "cpu"));
	run_steps(worlds[0], 60);
	run_steps(worlds[1], 60);
	assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
	scree_world_destroy(worlds[0]);
	scree_world_destroy(worlds[1]);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(sleepers_have_equal_bits),
	                                   cmocka_unit_test(moved_sleepers_have_equal_bits)};
	return cmocka_run_group_tests(tests, find_second_device, memory_is_released);
}
