// SPDX-License-Identifier: MIT
// load.h -- reads a scene file and checks all of it.
#ifndef LOAD_H
#define LOAD_H
#include "scene/scene.h"

// Reads and checks a file. On an error it returns null and writes a sentence (SCENE_SENTENCE characters). The caller
// frees the scene.
Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence);
void scene_free(Scene* scene);

#endif
