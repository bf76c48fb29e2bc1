// SPDX-License-Identifier: MIT
// scene_keys.c -- keys that a scene may use, and their names in scene files.
#include "scene/scene_keys.h"

const char* const scene_key_names[SCENE_KEYS + 1] = {
#define X(name, glfw) #name,
#include "scene/scene_keys.def"
#undef X
};
