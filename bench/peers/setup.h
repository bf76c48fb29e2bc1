// SPDX-License-Identifier: MIT
// setup.h -- the scene of a trial: read from a file, or made by code.
#ifndef SETUP_H
#define SETUP_H
#include "fixture.h"
#include "scene/scene.h"

typedef struct
{
	Scene* scene;           // null if made by code
	const Fixture* fixture; // null if in a file
	double values[FIXTURE_PARAMETERS];
	float dt; // s
	int substeps, steps;
} Setup;

// Finds the scene of this name, made by code or in a file, and sets its parameters. Returns false after printing a sentence.
// The caller frees what it holds.
bool setup_load(Setup* setup, const char* name, const char* executable, const SceneSetting* settings, int count);
void setup_free(Setup* setup);

// The definition of its world; the caller sets device, threads and lanes.
scree_world_def setup_world(const Setup* setup);

// Builds the bodies and joints in a new world. Returns false after printing a sentence.
bool setup_fill(const Setup* setup, scree_world* world);

// Makes a world on the CPU with its bodies and joints. Returns null after printing a sentence. threads 0: one a core.
scree_world* setup_open(const Setup* setup, int threads);

// Whether the bodies change between steps.
bool setup_changes(const Setup* setup);

// Changes the bodies as the scene does before a step. Returns false after printing a sentence.
bool setup_change(const Setup* setup, scree_world* world, int64_t step);

#endif
