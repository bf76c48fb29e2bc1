// SPDX-License-Identifier: MIT
// test_recovery_scenes.c -- checks that each scene goes on on the CPU with the same bits when its device fails.
//
// Formula: hash(world whose device fails, step) = hash(world on the CPU, step).
#include "support/fake_gpu.h"
#include "support/log_lines.h"
#include "support/small_scenes.h"

#define INTERVAL 7

static int fails_at; // step before which the device fails

// Steps a scenario. The device fails within a change of the user or within the step. Returns the hash at the end.
static uint64_t run_scene(const Scenario* scenario, int interval, int steps)
{
	scree_world_def def = scenario->def;
	def.device = "cpu";
	def.threads = 2;
	def.recovery_interval = interval;
	scree_world* world = create_world(&def);
	if (interval > 0)
		become_fake_gpu(world);
	scenario->build(world, scenario->context);
	for (int step = 0; step < steps; ++step)
	{
		if (interval > 0 && step == fails_at)
			fake_gpu_falls();
		if (scenario->act)
			scenario->act(world, step, scenario->context);
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
	}
	uint64_t hash = hash_of(world);
	assert_string_equal(scree_world_get_device(world), "cpu");
	scree_world_destroy(world);
	return hash;
}

static void scene_recovers(const Scenario* scenario)
{
	int steps = scenario->steps / 2 > INTERVAL ? scenario->steps / 2 : INTERVAL + 2;
	uint64_t expected = run_scene(scenario, 0, steps);
	int failures[] = {0, INTERVAL, steps - 1};
	for (size_t k = 0; k < sizeof failures / sizeof *failures; ++k)
	{
		int before = warning_count;
		fails_at = failures[k];
		if (run_scene(scenario, INTERVAL, steps) != expected)
			fail_msg("%s: another hash after a failure before step %d of %d", scenario->name, fails_at, steps);
		if (!was_logged("the world goes on on the CPU") || warning_count != before + 1)
			fail_msg("%s: %d warnings, the last is \"%s\"", scenario->name, warning_count - before, last_warning);
	}
}

static void scenes_recover(void** state)
{
	(void)state;
	for_every_scene(scene_recovers);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(scenes_recover)};
	return cmocka_run_group_tests(tests, keep_log, release_log);
}
