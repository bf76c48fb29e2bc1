// SPDX-License-Identifier: MIT
// test_traffic.c -- checks the number of bytes of the solve stage against sums made by hand, and the measured
// bandwidth.
#include "support/allocations.h"
#include "support/make_bodies.h"
#include <stdlib.h>
#include <string.h>

static scree_traffic traffic_of(scree_world* world)
{
	scree_traffic traffic;
	OK(scree_world_get_traffic(world, &traffic));
	return traffic;
}

// A box on a floor: one constraint, and three rows in the pools of bodies. One of these rows is the ground of the
// world.
static void a_box_on_the_floor(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_traffic before = traffic_of(world);
	assert_int_equal(before.constraints + before.passes, 0);
	assert_int_equal(before.constraint_bytes + before.body_bytes, 0);
	add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	run_steps(world, 1);

	// Bytes of a constraint in each pass:
	// prepare 180: slot 4, pair 8, two places 64, points 64, normal 8, arms 24, gaps 8;
	// warm start 64: indices 8, normal and arms 32, impulses 24;
	// bias 64: indices, normal, arms and gaps 48, normal impulses (read and written) 16;
	// relax 84: the same 48, friction 4, all impulses (read and written) 32.
	scree_traffic traffic = traffic_of(world);
	assert_int_equal(traffic.constraints, 1);
	assert_int_equal(traffic.passes, 1 + 2 * 4);
	assert_int_equal(traffic.constraint_bytes, 180 + 64 + 4 * (64 + 84));
	// A pass reads 32 bytes of each body and writes 16. A row of the pool body costs 44 bytes once per step. Each
	// substep adds 128 bytes to update its velocity (state read and written: 64; motion read: 32; base read and
	// written: 32) and 96 to update its position.
	assert_int_equal(traffic.body_bytes, 9 * 2 * (32 + 16) + 3 * (44 + 4 * (128 + 96)));

	// restitution adds one pass, and bytes to each constraint
	scree_attribute_def def = scree_attribute_def_default();
	def.restitution = 0.5f;
	add_attribute(world, &def);
	traffic = traffic_of(world);
	assert_int_equal(traffic.passes, 9);
	OK(scree_world_step(world, STEP, 2));
	traffic = traffic_of(world);
	assert_int_equal(traffic.constraints, 1);
	assert_int_equal(traffic.passes, 1 + 2 * 2 + 1);
	// Bytes added by restitution:
	// prepare 80: slot 4, normal and arms 32, gaps 8, totals 8, indices 8, restitution 4, fall 4, energy 4, rebounds 8;
	// warm start 4, bias 8, relax 40;
	// bounce 96: indices, normal, arms and gaps 48, fall 4, energy 4, rebounds 8, totals (read and written) 16,
	// impulses 16.
	assert_int_equal(traffic.constraint_bytes, 260 + 68 + 2 * (72 + 124) + 96);
	// prepare reads state, motion and colors of each body
	assert_int_equal(traffic.body_bytes, (6 * 48 + 72) * 2 + 3 * (44 + 2 * 224));
	scree_world_destroy(world);
}

// The measurement frees its memory and does not change the world. The test limits the size of allocations, so that a
// CPU measures smaller blocks in less time.
static void bandwidth_is_measured(void** state)
{
	(void)state;
	count_allocations();
	largest_allocation = (size_t)16 << 20;
	scree_world* world = open_test_world(-10.0f);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	run_steps(world, 3);
	uint64_t hash = hash_of(world);
	size_t memory = scree_memory();
	double bandwidth = -1.0;
	OK(scree_world_measure_bandwidth(world, &bandwidth));
	assert_true(bandwidth > 1e7 && bandwidth < 1e14);
	assert_int_equal(scree_memory(), memory);
	assert_true(hash_of(world) == hash);
	run_steps(world, 1);
	scree_world_destroy(world);
	OK(scree_hooks_set(NULL));
}

// On the CPU the allocation hook allocates the blocks. If it fails, the measurement returns an error.
static void bandwidth_takes_what_there_is(void** state)
{
	(void)state;
	if (strcmp(test_device, "cpu") != 0)
		return;
	count_allocations();
	largest_allocation = (size_t)16 << 20;
	scree_world* world = open_test_world(-10.0f);
	double bandwidth = -1.0;
	largest_allocation = 100000;
	assert_int_equal(scree_world_measure_bandwidth(world, &bandwidth), SCREE_ERROR_OUT_OF_MEMORY);
	assert_non_null(strstr(scree_error(), "no memory for two blocks"));
	assert_true(bandwidth == -1.0);
	run_steps(world, 1);
	scree_world_destroy(world);
	OK(scree_hooks_set(NULL));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_box_on_the_floor),
	    cmocka_unit_test(bandwidth_is_measured),
	    cmocka_unit_test(bandwidth_takes_what_there_is),
	};
	return RUN_ON_DEVICES(tests);
}
