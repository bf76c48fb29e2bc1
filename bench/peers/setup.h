// SPDX-License-Identifier: MIT
// setup.h -- loads the scene of a trial, from a file or made by code, and builds it in a world.
#ifndef SETUP_H
#define SETUP_H
#include "fixture.h"
#include "scene/scene.h"

typedef struct
{
	Scene* scene;           // scene from a file; null if the scene is made by code
	const Fixture* fixture; // scene made by code; null if the scene is from a file
	double values[FIXTURE_PARAMETERS];
	float dt; // s
	int substeps, steps;
} Setup;

// Finds the scene of this name, made by code or in a file, and sets its parameters. Returns false after printing a
// sentence. The caller calls setup_free afterwards.
bool setup_load(Setup* setup, const char* name, const char* executable, const SceneSetting* settings, int count);
void setup_free(Setup* setup);

// Returns the definition of the scene's world; the caller sets device, threads, lanes and sleep.
scree_world_def setup_world(const Setup* setup);

// Adds the bodies and joints of the scene to a new world. Returns false after printing a sentence.
bool setup_fill(const Setup* setup, scree_world* world);

// Creates a world on the CPU with the scene's bodies and joints. threads: number of threads, 0 for one per core.
// Returns null after printing a sentence.
scree_world* setup_open(const Setup* setup, int threads);

// Returns whether the scene changes bodies between steps.
bool setup_changes(const Setup* setup);

// Makes the changes of the scene before a step. Returns false after printing a sentence.
bool setup_change(const Setup* setup, scree_world* world, int64_t step);

#endif
