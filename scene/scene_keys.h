// SPDX-License-Identifier: MIT
// scene_keys.h -- the keys of the keyboard that a scene may use, and their names in scene files.
#ifndef SCENE_KEYS_H
#define SCENE_KEYS_H
#include "platform/exact_floats.h"

typedef enum
{
#define X(name, glfw) SCENE_KEY_##name,
#include "scene/scene_keys.def"
#undef X
	SCENE_KEYS, // number of keys, at most 32
} SceneKey;

extern const char* const scene_key_names[SCENE_KEYS + 1]; // the last name is null

#endif
