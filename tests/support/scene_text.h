// SPDX-License-Identifier: MIT
// scene_text.h -- loads scenes from text.
#ifndef SCENE_TEXT_H
#define SCENE_TEXT_H
#include "scene/load.h"
#include "scene/player.h"
#include "support/checks.h"
#include <stdio.h>

#define HEAD            "{\"name\": \"x\", \"title\": \"y\", "
#define GOOD_ATTRIBUTES "\"attributes\": {\"a\": {\"circle\": 1}, \"b\": {\"box\": [1, 2]}}, "

// Writes a text to a file, loads the scene from this file, and removes the file. path: name of the file.
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

// Loads a scene from a text, which must be valid.
static inline Scene* load_good_text(const char* path, const char* text)
{
	char sentence[SCENE_SENTENCE] = "";
	Scene* scene = load_text(path, text, NULL, 0, sentence);
	if (!scene)
		fail_msg("%s", sentence);
	return scene;
}

// Opens the player of a valid scene on the CPU with one thread.
static inline ScenePlayer open_text(const char* path, const char* text)
{
	ScenePlayer player;
	const Scene* scene = load_good_text(path, text);
	scree_world_def def = scene->world;
	def.device = "cpu";
	def.threads = 1;
	OK(player_open(&player, scene, &def));
	return player;
}

// Closes a player and its scene.
static inline void close_text(ScenePlayer* player)
{
	Scene* scene = (Scene*)player->scene;
	player_close(player);
	scene_free(scene);
}

#endif
