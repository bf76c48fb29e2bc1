// SPDX-License-Identifier: MIT
// engine.h -- what an engine must do to be measured: hold a scene, step, say where its bodies are.
#ifndef ENGINE_H
#define ENGINE_H
#include "scene/scene.h"

// exit codes, as those of the command line
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // an engine or memory failed
#define EXIT_BAD    2 // a bad command line or scene

typedef struct
{
	int threads;
	const char* device; // of Scree, as in scree_world_def
	bool continuous;    // Box2D stops fast bodies at walls; Scree has no such stage yet
} EngineOptions;

typedef struct // functions return false after printing what is wrong
{
	const char* name;
	void* (*open)(const Scene* scene, const EngineOptions* options); // null on failure; the scene at its first step
	bool (*change)(void* state, int64_t step);                       // what the scene does to its bodies before a step
	bool (*step)(void* state, float dt, int substeps);
	bool (*wait)(void* state); // until all that was asked for is done
	// of all bodies, in the order of the scene
	bool (*poses)(void* state, scree_pose* poses, int count);
	bool (*hash)(void* state, uint64_t* hash); // the engine's own, of all simulated state
	void (*close)(void* state);
} Engine;

extern const Engine scree_engine, box2d_engine;

// A world with the scene in it, null after printing what is wrong. threads 0: one a core.
scree_world* open_world(const Scene* scene, const char* device, int threads);

// The handles of all bodies; the caller frees them. Null when there is no memory.
scree_body* list_bodies(const scree_world* world, int* count);

// Prints scree_error() unless the status is good; returns whether it is.
bool report(scree_status status);

#endif
