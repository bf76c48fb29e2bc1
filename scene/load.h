// SPDX-License-Identifier: MIT
// load.h -- reads a scene file and checks all of it.
#ifndef LOAD_H
#define LOAD_H
#include "scene/scene.h"

// Reads and checks a file. On an error it writes a message (SCENE_SENTENCE characters) and returns null. count:
// number of settings. The caller frees the scene.
Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence);
void scene_free(Scene* scene);

#endif
