// SPDX-License-Identifier: MIT
// load_scene.h -- loads scenes of the project with other settings.
#ifndef LOAD_SCENE_H
#define LOAD_SCENE_H
#include "scene/find.h"
#include "scene/load.h"
#include "support/checks.h"

// Loads a scene, or fails. settings: a list that ends at an entry without a name.
static inline Scene* load_scene(const char* name, const SceneSetting* settings)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	int count = 0;
	while (settings[count].name)
		++count;
	if (!scene_find(name, NULL, path, sentence))
		fail_msg("%s", sentence);
	Scene* scene = scene_load(path, settings, count, sentence);
	if (!scene)
		fail_msg("%s", sentence);
	return scene;
}

#endif
