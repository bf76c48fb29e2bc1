// SPDX-License-Identifier: MIT
// test_scene_write.c -- checks that worlds of scenes that are written as scene files and loaded again are equal.
//
// Formulas: hash(load(write(world))) = hash(world) before the first step, and after each number of steps on every device;
// write(load(write(world))) = write(world), byte for byte, since no number is rounded.
#include "scree/scree_scene.h"
#include "support/small_scenes.h"
#include "support/variants.h"
#include "support/written_scenes.h"
#include <stdio.h>
#include <string.h>

#define STEPS 60

static Variant variants[MAX_VARIANTS];
static int variant_count, scenes;

static void check_scene(const Scenario* scenario)
{
	const Scene* scene = scenario->context;
	ScenePlayer player;
	scree_scene_info info = scree_scene_info_default();
	scree_world_def def = scene->world;
	size_t size;
	def.device = "cpu";
	def.threads = 1;
	OK(player_open(&player, scene, &def));
	info.dt = scene->dt;
	info.substeps = scene->substeps;
	char* text = write_scene(player.world, &info, &size);
	scree_scene* loaded = load_written(text, size, "cpu");
	char* again = write_scene(scree_scene_get_world(loaded), &info, &size);
	if (strcmp(text, again) != 0)
		fail_msg("%s: another text", scenario->name);
	scree_scene_free_text(again);
	check_same_hash(scenario->name, player.world, scree_scene_get_world(loaded));
	for (int step = 0; step < STEPS; ++step)
	{
		OK(scree_world_step(player.world, scene->dt, scene->substeps));
		OK(scree_scene_step(loaded));
	}
	check_same_hash(scenario->name, player.world, scree_scene_get_world(loaded));
	scree_scene_destroy(loaded);

	// quick builds run a third of the scenes on other devices
	int others = quick() && scenes++ % 3 > 0 ? 0 : variant_count;
	for (int k = 0; k < others; ++k)
	{
		bool opencl = strncmp(variants[k].device, "opencl", 6) == 0;
		if (!opencl || strcmp(variants[k].device, variants[k - 1].device) == 0)
			continue;
		loaded = load_written(text, size, variants[k].device);
		for (int step = 0; step < STEPS; ++step)
			OK(scree_scene_step(loaded));
		check_same_hash(variants[k].name, player.world, scree_scene_get_world(loaded));
		// a world on the device is written as one on the CPU
		char* there = write_scene(scree_scene_get_world(loaded), &info, &size);
		again = write_scene(player.world, &info, &size);
		assert_string_equal(there, again);
		scree_scene_free_text(there);
		scree_scene_free_text(again);
		scree_scene_destroy(loaded);
	}
	scree_scene_free_text(text);
	// the origin of a body is rounded when its center of mass is another point
	check_same_text(scenario->name, player.world, &info, 3);
	player_close(&player);
}

static void test_scenes(void** state)
{
	(void)state;
	variant_count = list_variants(variants);
	for_every_scene(check_scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_scenes),
	};
	return cmocka_run_group_tests(tests, NULL, memory_is_released);
}
