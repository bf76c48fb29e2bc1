// SPDX-License-Identifier: MIT
// churn.h -- changes bodies of a scene between steps: moves some, replaces some by new bodies, and pushes some by
// explosions.
#ifndef CHURN_H
#define CHURN_H
#include "scene/scene.h"

// Returns true if the scene changes bodies between steps.
bool scene_churns(const Scene* scene);

// Applies the changes of the scene before a step, then its explosions; the first step is number 0. scene_build must
// have filled the world, and the world must have taken all earlier steps. Bodies that were added later stay unchanged.
// On failure scree_error() has the reason.
scree_status scene_churn(const Scene* scene, scree_world* world, int64_t step);

typedef struct // change of a body before a step, for callers without a world
{
	int item;      // index of the body in the order of the file
	bool replaced; // true: destroyed and created again; false: moved
	// moved body: only pose and velocity; replaced body: all members, `attribute` as a position in Scene.attributes
	scree_body_def body;
} SceneChange;

// Writes the changes before a step into *changes and returns their count, or -1 if memory is short. The changes of a
// block are consecutive: first the moved bodies, then the replaced bodies, each in ascending order of `item`. The
// caller frees *changes.
int scene_changes(const Scene* scene, int64_t step, SceneChange** changes);

#endif
