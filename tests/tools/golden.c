// SPDX-License-Identifier: MIT
// golden.c -- golden LANES THREADS PART: prints the hash of each scene in the format of tests/golden.txt, after
// 1/PART of its steps.
//
// It needs no test framework, so that it can be compiled for WebAssembly.
#include "../support/small_sizes.h"
#include "scene/find.h"
#include "scene/load.h"
#include "scene/player.h"
#include <inttypes.h>
#include <stdlib.h>

static void check(bool good, const char* sentence)
{
	if (good)
		return;
	fprintf(stderr, "golden: %s\n", sentence);
	exit(1);
}

static void run(const SmallScene* small, int lanes, int threads, int part)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	int settings = 0;
	while (small->settings[settings].name)
		++settings;
	check(scene_find(small->name, NULL, path, sentence), sentence);
	Scene* scene = scene_load(path, small->settings, settings, sentence);
	check(scene, sentence);
	scene->world.device = "cpu";
	scene->world.lanes = lanes;
	scene->world.threads = threads;

	ScenePlayer player;
	uint64_t hash;
	int steps = small->steps / part;
	check(player_open(&player, scene, &scene->world) == SCREE_OK, scree_error());
	for (int k = 0; k < steps; ++k)
		check(player_step(&player) == SCREE_OK, scree_error());
	check(scree_world_get_hash(player.world, &hash) == SCREE_OK, scree_error());
	printf("%s %d %016" PRIx64 "\n", small->name, steps, hash);
	player_close(&player);
	scene_free(scene);
}

int main(int count, char** arguments)
{
	check(count == 4, "usage: golden LANES THREADS PART");
	for (size_t k = 0; k < sizeof small_scenes / sizeof *small_scenes; ++k)
		run(small_scenes + k, atoi(arguments[1]), atoi(arguments[2]), atoi(arguments[3]));
	return 0;
}
