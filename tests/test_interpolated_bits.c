// SPDX-License-Identifier: MIT
// test_interpolated_bits.c -- checks that interpolated poses and rows of all scenes have the same bits on each device.
//
// Formula: hash(poses, rows) of one lane and one thread = hash of all lanes and 2 threads = hash of OpenCL.
#include "support/second_device.h"
#include "support/small_scenes.h"

#define EVERY 7 // steps between two comparisons

static uint64_t mix(uint64_t hash, const void* values, size_t bytes)
{
	const unsigned char* at = values;
	for (size_t k = 0; k < bytes; ++k)
		hash = (hash ^ at[k]) * 1099511628211u; // FNV-1a
	return hash;
}

static uint64_t mix_world(uint64_t hash, scree_world* world, float alpha)
{
	int bodies, rows;
	OK(scree_world_get_interpolated(world, alpha, NULL, NULL, 0, &bodies));
	OK(scree_world_get_interpolated_rows(world, alpha, NULL, 0, &rows));
	scree_pose* poses = malloc((size_t)bodies * sizeof *poses + 1);
	scree_render_row* shown = malloc((size_t)rows * sizeof *shown + 1);
	assert_true(poses && shown);
	OK(scree_world_get_interpolated(world, alpha, NULL, poses, bodies, &bodies));
	OK(scree_world_get_interpolated_rows(world, alpha, shown, rows, &rows));
	hash = mix(mix(hash, poses, (size_t)bodies * sizeof *poses), shown, (size_t)rows * sizeof *shown);
	free(poses);
	free(shown);
	return hash;
}

static uint64_t hash_on(const Scenario* scenario, const char* device, int threads, int lanes)
{
	static const float alphas[] = {0.0f, 1e-30f, 0.1234567f, 0.5f, 0.99999994f};
	scree_world_def def = scenario->def;
	def.device = device;
	def.threads = threads;
	def.lanes = lanes;
	scree_world* world = create_world(&def);
	uint64_t hash = 14695981039346656037u;
	scenario->build(world, scenario->context);
	for (int step = 0; step < scenario->steps / 2; ++step)
	{
		if (scenario->act)
			scenario->act(world, step, scenario->context);
		if (step % EVERY == 3) // after edits, before the step
			hash = mix_world(hash, world, 0.25f);
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
		if (step % EVERY == 0)
			hash = mix_world(hash, world, alphas[step / EVERY % 5]);
	}
	scree_world_destroy(world);
	return hash;
}

static void compare(const Scenario* scenario)
{
	uint64_t hash = hash_on(scenario, "cpu", 1, 1);
	if (hash_on(scenario, "cpu", 2, 0) != hash)
		fail_msg("%s: all lanes differ from one lane", scenario->name);
	if (second_device[0] && hash_on(scenario, second_device, 0, 0) != hash)
		fail_msg("%s: %s differs from the CPU", scenario->name, second_device);
}

static void scenes_have_equal_bits(void** state)
{
	(void)state;
	for_every_scene(compare);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(scenes_have_equal_bits, memory_is_released)};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
