// SPDX-License-Identifier: MIT
// load.h -- reads a scene file and checks all of it.
#ifndef LOAD_H
#define LOAD_H
#include "scene/scene.h"

// m: least size of a box of a picture. At a larger scale, the line of a shape has more pixels than Cairo draws in minutes.
#define LEAST_VIEW 0.00999f

// Reads and checks a file. On an error it writes a message (SCENE_SENTENCE characters) and returns null. count:
// number of settings. The caller frees the scene.
Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence);
// Likewise, from the text of a file, not ended by 0. name: of the file, for messages.
Scene* scene_parse(const void* text, size_t size, const char* name, const SceneSetting* settings, int count,
                   char* sentence);
void scene_free(Scene* scene);

#endif
