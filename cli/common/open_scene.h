// SPDX-License-Identifier: MIT
// open_scene.h -- opens the scenes and the worlds that the options select.
#ifndef OPEN_SCENE_H
#define OPEN_SCENE_H
#include "options.h"
#include "scene/player.h"

// Loads a scene with the settings of the options. On failure it prints an error message and returns null.
Scene* open_scene(const Options* options, const char* name);

typedef struct
{
	Scene** scenes;
	int count;
} SceneList;

// Loads the scenes of the arguments, or all scenes if there is no argument. On failure it prints an error message.
// Returns an exit code. The caller closes the list also on failure.
int open_scenes(const Options* options, SceneList* list);
void close_scenes(SceneList* list);

// Opens a player on the device of the options. On failure it prints an error message. Returns an exit code.
int open_player(const Options* options, const Scene* scene, bool timings, ScenePlayer* player);

#endif
