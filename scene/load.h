// SPDX-License-Identifier: MIT
// load.h -- reads a scene file and checks all of it.
#ifndef LOAD_H
#define LOAD_H
#include "scene/scene.h"

// Reads and checks a file. When anything in it is wrong, returns null and writes a sentence (SCENE_SENTENCE characters).
// The caller frees the scene.
Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence);
void scene_free(Scene* scene);

// Reads the title and the parameters with their defaults ("rows=100 columns=20") of a file. False writes a sentence.
bool scene_heading(const char* path, char* title, size_t title_size, char* parameters, size_t parameters_size,
                   char* sentence);

// Writes what a parameter means, with its bounds. False writes a sentence.
bool scene_parameter_help(const char* path, const char* name, char* help, size_t size, char* sentence);

#endif
