// SPDX-License-Identifier: MIT
// churn.h -- changes of a scene's bodies between steps: some are moved to another place, some destroyed and created
// again, some pushed by explosions.
#ifndef CHURN_H
#define CHURN_H
#include "scene/scene.h"

// Returns true if the scene changes bodies between steps.
bool scene_churns(const Scene* scene);

// Applies the changes of the scene before a step, then its explosions; the first step is number 0. The world must have
// been built by scene_build and have taken all steps before this one. Bodies that were added later stay unchanged. On
// failure scree_error() has the reason.
scree_status scene_churn(const Scene* scene, scree_world* world, int64_t step);

typedef struct // change of one body by scene_churn, for callers without a world
{
	int item;      // index of the body in the order of the file
	bool replaced; // destroyed and created again; else moved
	// new pose and velocity; if replaced, all members; the attribute is a position in Scene.attributes
	scree_body_def body;
} SceneChange;

// Writes the changes before a step into *changes and returns their count, or -1 if memory is short. Those of a block
// are consecutive: first the moved bodies, then the replaced ones, each in ascending order of the items. The caller
// frees *changes.
int scene_changes(const Scene* scene, int64_t step, SceneChange** changes);

#endif
