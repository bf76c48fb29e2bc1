// SPDX-License-Identifier: MIT
// scene_text.h -- scenes from text, for tests of scene files.
#ifndef SCENE_TEXT_H
#define SCENE_TEXT_H
#include "scene/load.h"

#define HEAD            "{\"name\": \"x\", \"title\": \"y\", "
#define GOOD_ATTRIBUTES "\"attributes\": {\"a\": {\"circle\": 1}, \"b\": {\"box\": [1, 2]}}, "

// Loads a scene through a file of this name, which is removed.
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

#endif
