// SPDX-License-Identifier: MIT
// written_scenes.c -- writes worlds as scenes, loads them again, and compares both worlds.
#include "support/written_scenes.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char* write_scene(scree_world* world, const scree_scene_info* info, size_t* size)
{
	char* text;
	OK(scree_scene_write_text(world, info, "written.json", &text, size));
	assert_int_equal(strlen(text), *size);
	return text;
}

scree_scene* load_written(const char* text, size_t size, const char* device)
{
	scree_world_def world = scree_world_def_default();
	scree_scene_def def = scree_scene_def_default();
	scree_scene* scene;
	world.device = device;
	world.threads = 1;
	def.world = &world;
	OK(scree_scene_load_text(text, size, "written.json", &def, &scene));
	return scene;
}

void check_same_hash(const char* what, scree_world* a, scree_world* b)
{
	uint64_t hashes[2];
	const void* bytes[2];
	size_t sizes[2];
	static scree_difference differences[512];
	int count;
	OK(scree_world_get_hash(a, hashes));
	OK(scree_world_get_hash(b, hashes + 1));
	if (hashes[0] == hashes[1])
		return;
	OK(scree_world_snapshot(a, bytes, sizes));
	OK(scree_world_snapshot(b, bytes + 1, sizes + 1));
	OK(scree_snapshots_compare(bytes[0], sizes[0], bytes[1], sizes[1], differences, 512, &count));
	for (int k = 0; k < count && k < 512; ++k)
		if (strncmp(differences[k].column, "pool.", 5) ==
		    0) // the hash depends on some of these, and on hidden values of the host
			print_error("%s %s: items %d and %d, of which %d differ; item %d: %" PRIx64 " and %" PRIx64 "\n",
			            differences[k].column, differences[k].word, differences[k].count_a, differences[k].count_b,
			            differences[k].items, differences[k].item, differences[k].value_a, differences[k].value_b);
	fail_msg("%s: the hashes differ", what);
}

static void print_difference(const char* a, const char* b)
{
	size_t k = 0;
	while (a[k] == b[k])
		++k;
	k -= k < 150 ? k : 150;
	print_error("%.400s\n--- instead of\n%.400s\n", b + k, a + k);
}

void check_same_text(const char* what, scree_world* world, const scree_scene_info* info, int rounds)
{
	size_t size, next_size;
	char* text = write_scene(world, info, &size);
	bool same = false;
	for (int round = 0; round < rounds && !same; ++round)
	{
		scree_scene* scene = load_written(text, size, "cpu");
		char* next = write_scene(scree_scene_get_world(scene), info, &next_size);
		scree_scene_destroy(scene);
		same = next_size == size && memcmp(text, next, size) == 0;
		if (!same && round == rounds - 1)
			print_difference(text, next);
		scree_scene_free_text(text);
		text = next;
		size = next_size;
	}
	scree_scene_free_text(text);
	if (!same)
		fail_msg("%s: another text after %d rounds", what, rounds);
}
