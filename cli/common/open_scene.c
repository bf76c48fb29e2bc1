// SPDX-License-Identifier: MIT
// open_scene.c -- opens the scenes and the worlds that the options select.
#include "open_scene.h"
#include "library_error.h"
#include "scene/find.h"
#include "scene/load.h"
#include <stdlib.h>

Scene* open_scene(const Options* options, const char* name)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	Scene* scene = NULL;
	if (scene_find(name, options->executable, path, sentence))
		scene = scene_load(path, options->settings, options->setting_count, sentence);
	if (!scene)
		fprintf(stderr, "%s: %s\n", program_name, sentence);
	return scene;
}

static int open_named(const Options* options, char** names, int count, SceneList* list)
{
	list->scenes = calloc((size_t)count, sizeof(Scene*));
	int code = list->scenes ? EXIT_GOOD : EXIT_FAILED;
	if (!list->scenes)
		fprintf(stderr, "%s %s: out of memory for %d scenes\n", program_name, options->name, count);
	for (int k = 0; k < count && code == EXIT_GOOD; ++k)
	{
		Scene* scene = open_scene(options, names[k]);
		if (scene)
			list->scenes[list->count++] = scene;
		else
			code = EXIT_BAD;
	}
	return code;
}

int open_scenes(const Options* options, SceneList* list)
{
	*list = (SceneList){0};
	if (options->argument_count > 0)
		return open_named(options, options->arguments, options->argument_count, list);
	char **names, missing[SCENE_SENTENCE];
	int count = scene_list(options->executable, &names, missing);
	if (count == 0)
		fprintf(stderr, "%s %s: %s\n", program_name, options->name, missing);
	int code = count > 0 ? open_named(options, names, count, list) : EXIT_FAILED;
	for (int k = 0; k < count; ++k)
		free(names[k]);
	free(names);
	return code;
}

void close_scenes(SceneList* list)
{
	for (int k = 0; k < list->count; ++k)
		scene_free(list->scenes[k]);
	free(list->scenes);
	*list = (SceneList){0};
}

int open_player(const Options* options, const Scene* scene, bool timings, ScenePlayer* player)
{
	scree_world_def def = scene->world;
	def.device = options->device;
	def.threads = options->threads;
	def.lanes = options->lanes;
	def.allow_unequal_bits = options->allow_unequal_bits;
	def.timings = timings;
	def.recovery_interval = options->recovery_interval;
	def.sleep = scene_sleeps(scene, options->sleep);
	def.opengl = options->opengl;
	int code = report(player_open(player, scene, &def));
	if (code != EXIT_GOOD)
		player_close(player);
	return code;
}
