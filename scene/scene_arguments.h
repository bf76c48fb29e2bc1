// SPDX-License-Identifier: MIT
// scene_arguments.h -- checks the definitions that programs give to the functions of scree_scene.h.
#ifndef SCENE_ARGUMENTS_H
#define SCENE_ARGUMENTS_H
#include "scene/scene.h"

// Writes a sentence about an argument, and returns SCREE_ERROR_INVALID.
#define REFUSE(sentence, ...) (snprintf(sentence, SCENE_SENTENCE, __VA_ARGS__), SCREE_ERROR_INVALID)

// Copies the definition of a program, which may be of another version of the header, and checks it. On failure writes a sentence
// (SCENE_SENTENCE characters).
scree_status arguments_load(const char* function, const scree_scene_def* given, scree_scene_def* def, char* sentence);

// Makes the definition of a scene's world, with the device and the like of another definition, which may be null, or of another
// version of the header.
scree_status arguments_world(const char* function, const Scene* scene, const scree_world_def* over,
                             scree_world_def* def, char* sentence);

// Copies the settings of a file to a scene; null: the defaults. Checks those that scene_write does not check.
scree_status arguments_write(const char* function, const scree_scene_info* given, Scene* scene, char* sentence);

#endif
