// SPDX-License-Identifier: MIT
// mirror.h -- builds a setup in an engine. Engines other than Scree get the bodies and joints of a Scree world.
#ifndef MIRROR_H
#define MIRROR_H
#include "setup.h"
#include "validate/engine.h"

typedef struct
{
	const Setup* setup;
	const Engine* engine;
	void* state; // state of the engine
	// If the engine is Scree, its world. Otherwise the model: a Scree world that is never stepped, whose bodies are at
	// the poses that the setup last gave them.
	scree_world* world;
	scree_body* bodies;  // bodies of the world, in ascending index order
	int* indices;        // indices of the bodies in the engine, equal to the indices of their handles
	scree_joint* joints; // joints of the model
	int count, joint_count;
} Mirror;

// Functions that return a bool return false after printing a sentence; the caller must call mirror_close also after a
// failure.
bool mirror_open(Mirror* mirror, const Setup* setup, const Engine* engine, const EngineOptions* options);
bool mirror_change(Mirror* mirror, int64_t step); // changes the bodies as the setup does before a step
bool mirror_step(const Mirror* mirror);
bool mirror_poses(const Mirror* mirror, scree_pose* poses); // reads the poses of all bodies
void mirror_close(Mirror* mirror);

#endif
