// SPDX-License-Identifier: MIT
// test_scene_programs.c -- checks that worlds of random programs are written as scenes and loaded again.
//
// Formula: write(load(write(world))) = write(world), byte for byte, and equal hashes of two loaded worlds.
#include "programs/program.h"
#include "support/written_scenes.h"
#include <stdio.h>
#include <string.h>

// Checks the world that a program left. Returns false if a value is beyond those of scene files.
static bool check_world(scree_world* world, const char* name)
{
	char* text;
	size_t size;
	if (scree_scene_write_text(world, NULL, name, &text, &size) != SCREE_OK)
	{
		if (!strstr(scree_error(), "in a scene file") && !strstr(scree_error(), "length_unit"))
			fail_msg("%s: %s", name, scree_error());
		return false;
	}
	scree_scene *a = load_written(text, size, "cpu"), *b = load_written(text, size, "cpu");
	for (int step = 0; step < 10; ++step)
	{
		OK(scree_scene_step(a));
		OK(scree_scene_step(b));
	}
	check_same_hash(name, scree_scene_get_world(a), scree_scene_get_world(b));
	scree_scene_destroy(a);
	scree_scene_destroy(b);
	scree_scene_free_text(text);
	check_same_text(name, world, NULL, 3);
	return true;
}

static void test_programs(void** state)
{
	(void)state;
	Place places[2] = {{.device = "cpu", .threads = 1, .lanes = 1}, {.device = "cpu", .threads = 1}};
	int count = quick() ? 40 : 200, written = 0;
	for (int k = 0; k < count; ++k)
	{
		char name[64];
		Pair pair = {0};
		Program program = {0};
		snprintf(name, sizeof name, "program %d", k);
		program_make(&program, 5000 + (uint64_t)k, 60 + k);
		pair_open(&pair, places);
		pair_run(&pair, &program, NULL);
		written += pair.worlds[0] && check_world(pair.worlds[0], name);
		pair_close(&pair);
		program_close(&program);
	}
	print_message("%d of %d programs written\n", written, count);
	assert_true(written > count / 2);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_programs),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
