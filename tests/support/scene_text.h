// SPDX-License-Identifier: MIT
// scene_text.h -- scenes that are loaded from text.
#ifndef SCENE_TEXT_H
#define SCENE_TEXT_H
#include "scene/build.h"
#include "scene/load.h"
#include "support/checks.h"
#include <stdio.h>

#define HEAD            "{\"name\": \"x\", \"title\": \"y\", "
#define GOOD_ATTRIBUTES "\"attributes\": {\"a\": {\"circle\": 1}, \"b\": {\"box\": [1, 2]}}, "

// Loads a scene through a file of this name, and removes the file.
static inline Scene* load_text(const char* path, const char* text, const SceneSetting* settings, int count,
                               char* sentence)
{
	FILE* file = fopen(path, "w");
	assert_non_null(file);
	fputs(text, file);
	fclose(file);
	Scene* scene = scene_load(path, settings, count, sentence);
	remove(path);
	return scene;
}

// Loads a scene that must be valid.
static inline Scene* load_good_text(const char* path, const char* text)
{
	char sentence[SCENE_SENTENCE] = "";
	Scene* scene = load_text(path, text, NULL, 0, sentence);
	if (!scene)
		fail_msg("%s", sentence);
	return scene;
}

// Opens the world of a scene on the CPU with one thread.
static inline scree_world* open_scene_world(const Scene* scene)
{
	scree_world_def def = scene->world;
	def.device = "cpu";
	def.threads = 1;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	OK(scene_build(scene, world));
	return world;
}

#endif
