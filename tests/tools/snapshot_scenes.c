// SPDX-License-Identifier: MIT
// snapshot_scenes.c -- snapshot_scenes DEVICE STEPS SIZE FOLDER SCENE...: writes a snapshot of each scene, in the size of its file
// (SIZE whole) or in that of tests (small), after STEPS steps, as FOLDER/SCENE.snap. Then prints the hash after 300 more steps,
// which change nothing between them: SCENE, duration of a step, substeps, number of steps, hash. Without SCENE: all scenes.
//
// tests/web/snapshots.mjs restores the snapshots in WebAssembly, and repeats the steps.
#include "../support/small_sizes.h"
#include "scene/find.h"
#include "scene/load.h"
#include "scene/player.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MORE 300 // steps after the snapshot

static void check(bool good, const char* sentence)
{
	if (good)
		return;
	fprintf(stderr, "snapshot_scenes: %s\n", sentence);
	exit(1);
}

static void write_snapshot(scree_world* world, const char* folder, const char* name)
{
	const void* bytes;
	size_t size;
	char path[4096];
	check(scree_world_snapshot(world, &bytes, &size) == SCREE_OK, scree_error());
	snprintf(path, sizeof path, "%s/%s.snap", folder, name);
	FILE* file = fopen(path, "wb");
	check(file && fwrite(bytes, 1, size, file) == size && fclose(file) == 0, path);
}

static void run(const SmallScene* small, bool whole, const char* device, int steps, const char* folder)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	int settings = 0;
	while (!whole && small->settings[settings].name)
		++settings;
	check(scene_find(small->name, NULL, path, sentence), sentence);
	Scene* scene = scene_load(path, small->settings, settings, sentence);
	check(scene, sentence);
	scree_world_def def = scene->world;
	def.device = device;

	ScenePlayer player;
	uint64_t hash;
	check(player_open(&player, scene, &def) == SCREE_OK, scree_error());
	for (int k = 0; k < steps; ++k)
		check(player_step(&player) == SCREE_OK, scree_error());
	write_snapshot(player.world, folder, small->name);
	for (int k = 0; k < MORE; ++k)
		check(player_advance(&player) == SCREE_OK, scree_error());
	check(scree_world_get_hash(player.world, &hash) == SCREE_OK, scree_error());
	printf("%s %.9g %d %d %016" PRIx64 "\n", small->name, (double)scene->dt, scene->substeps, MORE, hash);
	player_close(&player);
	scene_free(scene);
}

int main(int count, char** arguments)
{
	check(count >= 5, "usage: snapshot_scenes DEVICE STEPS whole|small FOLDER SCENE...");
	bool whole = strcmp(arguments[3], "whole") == 0;
	int found = 0;
	for (size_t k = 0; k < sizeof small_scenes / sizeof *small_scenes; ++k)
	{
		bool wanted = count == 5;
		for (int name = 5; name < count; ++name)
			wanted = wanted || strcmp(arguments[name], small_scenes[k].name) == 0;
		found += wanted;
		if (wanted)
			run(small_scenes + k, whole, arguments[1], atoi(arguments[2]), arguments[4]);
	}
	check(count == 5 || found == count - 5, "there is no scene with one of these names");
	return 0;
}
