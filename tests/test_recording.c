// SPDX-License-Identifier: MIT
// test_recording.c -- checks that a recording of any scene is repeated with the same bits on any device.
//
// Formula: hash(replay, step) = hash(recorded world, step). Random programs also record and repeat all of their calls
// (tests/programs/recorded.c).
#include "support/recordings.h"
#include "support/second_device.h"
#include "support/small_scenes.h"

static void scene_repeats(const Scenario* scenario)
{
	scree_world_def def = scenario->def;
	def.device = "cpu";
	def.threads = 2;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	int steps = scenario->steps < 40 ? scenario->steps : 40, begin = steps / 4;
	bool early = scenario->steps % 2 == 0; // some recordings contain the calls that build the scene
	if (early)
		record_hashes(world);
	scenario->build(world, scenario->context);
	for (int step = 0; step < steps; ++step)
	{
		if (step == begin && !early)
			record_hashes(world);
		if (scenario->act)
			scenario->act(world, step, scenario->context);
		OK(scree_world_step(world, scenario->dt, scenario->substeps));
	}
	OK(scree_world_end_recording(world));
	uint64_t hash = hash_of(world);
	Saved saved = recording_of(world);
	scree_world_destroy(world);
	assert_true(repeat_on(saved, def_on("cpu", 1, 1)) == hash);
	assert_true(repeat_on(saved, def_on("cpu", 2, 8)) == hash);
	if (second_device[0])
		assert_true(repeat_on(saved, def_on(second_device, 0, 0)) == hash);
	free(saved.bytes);
}

static void scenes_repeat(void** state)
{
	(void)state;
	for_every_scene(scene_repeats);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_repeat),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
