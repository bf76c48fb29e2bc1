// SPDX-License-Identifier: MIT
// engine.h -- the functions of an engine that is measured.
#ifndef ENGINE_H
#define ENGINE_H
#include "setup.h"

// exit codes, as those of the command line
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // an engine or memory failed
#define EXIT_BAD    2 // a bad command line or scene

typedef struct
{
	int threads;
	const char* device; // of Scree, as in scree_world_def
	bool continuous;    // continuous collision of Box2D
} EngineOptions;

typedef struct // functions return false after printing a sentence
{
	const char* name;
	void* (*open)(const Setup* setup, const EngineOptions* options); // null on failure
	bool (*change)(void* state, int64_t step); // changes the bodies as the scene does before a step
	bool (*step)(void* state, float dt, int substeps);
	bool (*wait)(void* state); // until all work is done
	// of all bodies, in the order of the scene
	bool (*poses)(void* state, scree_pose* poses, int count);
	bool (*hash)(void* state, uint64_t* hash); // of all simulated state, by the engine
	void (*close)(void* state);
} Engine;

#endif
