// SPDX-License-Identifier: MIT
// scene_keys.c -- the names in scene files of the keys that a scene may use.
#include "scene/scene_keys.h"

const char* const scene_key_names[SCENE_KEYS + 1] = {
#define X(name, glfw) #name,
#include "scene/scene_keys.def"
#undef X
};
