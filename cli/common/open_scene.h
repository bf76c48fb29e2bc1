// SPDX-License-Identifier: MIT
// open_scene.h -- opens the scenes and the worlds that options name.
#ifndef OPEN_SCENE_H
#define OPEN_SCENE_H
#include "options.h"
#include "simulation.h"

// Loads a scene with the settings of the options. Returns null after printing a sentence.
Scene* open_scene(const Options* options, const char* name);

typedef struct
{
	Scene** scenes;
	int count;
} SceneList;

// Loads the scenes of the arguments; all that there are, if there is no argument. Returns an exit code after printing a
// sentence. The caller closes the list also on failure.
int open_scenes(const Options* options, SceneList* list);
void close_scenes(SceneList* list);

// Opens a simulation of a scene on the device of the options. Returns an exit code after printing a sentence.
int open_simulation(const Options* options, const Scene* scene, bool timings, Simulation* simulation);

#endif
