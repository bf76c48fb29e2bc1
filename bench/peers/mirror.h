// SPDX-License-Identifier: MIT
// mirror.h -- a setup in an engine: Scree builds it itself, other engines get the bodies and joints of a Scree world.
#ifndef MIRROR_H
#define MIRROR_H
#include "setup.h"
#include "validate/engine.h"

typedef struct
{
	const Setup* setup;
	const Engine* engine;
	void* state; // state of the engine
	// world of the engine if that is Scree; else a model that is never stepped, with the bodies as the setup last placed them
	scree_world* world;
	scree_body* bodies;  // bodies of the world, by rising index
	int* indices;        // indices of the bodies in the engine, as in their handles
	scree_joint* joints; // joints of the model
	int count, joint_count;
} Mirror;

// These return false after printing a sentence. The caller closes the mirror also then.
bool mirror_open(Mirror* mirror, const Setup* setup, const Engine* engine, const EngineOptions* options);
bool mirror_change(Mirror* mirror, int64_t step); // changes the bodies as the setup does before a step
bool mirror_step(const Mirror* mirror);
bool mirror_poses(const Mirror* mirror, scree_pose* poses); // reads the poses of all bodies
void mirror_close(Mirror* mirror);

#endif
