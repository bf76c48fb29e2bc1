// SPDX-License-Identifier: MIT
// scene_hash.c -- scene_hash SCENE STEPS DEVICE FORM: prints the hash of a scene as scree hash does, but with a given
// form of the solve.
#include "scene/find.h"
#include "scene/load.h"
#include "scene/player.h"
#include "support/form_names.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static scree_status hash_scene(const Scene* scene, const char* device, int steps, uint64_t* hash)
{
	scree_world_def def = scene->world;
	def.device = device;
	ScenePlayer player;
	scree_status status = player_open(&player, scene, &def);
	for (int step = 0; step < steps && status == SCREE_OK; ++step)
		status = player_step(&player);
	if (status == SCREE_OK)
		status = scree_world_get_hash(player.world, hash);
	player_close(&player);
	return status;
}

int main(int count, char** arguments)
{
	if (count != 5 || !form_choose(arguments[4]))
	{
		fprintf(stderr, "usage: scene_hash SCENE STEPS DEVICE default|launches|relay|tiles\n");
		return 2;
	}
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	Scene* scene = scene_find(arguments[1], NULL, path, sentence) ? scene_load(path, NULL, 0, sentence) : NULL;
	if (!scene)
	{
		fprintf(stderr, "scene_hash: %s\n", sentence);
		return 2;
	}
	uint64_t hash;
	scree_status status = hash_scene(scene, arguments[3], atoi(arguments[2]), &hash);
	scene_free(scene);
	if (status != SCREE_OK)
	{
		fprintf(stderr, "scene_hash: %s\n", scree_error());
		return 1;
	}
	printf("%016" PRIx64 "\n", hash);
	return 0;
}
