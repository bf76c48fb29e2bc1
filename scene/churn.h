// SPDX-License-Identifier: MIT
// churn.h -- what a scene does to its bodies between steps: some are moved to another place, some destroyed and created again, some
// blown up.
#ifndef CHURN_H
#define CHURN_H
#include "scene/scene.h"

// Whether the scene changes bodies between steps.
bool scene_churns(const Scene* scene);

// Changes the bodies of a world as the scene does before a step, then sets off its explosions; the first step is number 0. The world must have been built
// by scene_build and have taken all steps before this one. Bodies that were added later stay as they are. On failure
// scree_error() says why.
scree_status scene_churn(const Scene* scene, scree_world* world, int64_t step);

typedef struct // what scene_churn does to one body, for callers that do not have a world
{
	int item;      // index of the body in the order of the file
	bool replaced; // destroyed and created again; else moved
	// new pose and velocity; if replaced all members, the attribute as a position in Scene.attributes
	scree_body_def body;
} SceneChange;

// Writes the changes before a step into *changes and returns their count, or -1 when memory is short. Those of a block are
// consecutive: first the moved bodies, then the replaced ones, each by rising item. The caller frees *changes.
int scene_changes(const Scene* scene, int64_t step, SceneChange** changes);

#endif
