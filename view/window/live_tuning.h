// SPDX-License-Identifier: MIT
// live_tuning.h -- parameters of a running world that the user can change: gravity, substeps, solver tuning.
#ifndef LIVE_TUNING_H
#define LIVE_TUNING_H
#include "scene/scene.h"

typedef struct
{
	bool changed; // true if the user changed a value: then the values are kept when the scene restarts
	scree_vec gravity;
	int substeps;
	scree_tuning solver;
} Tuning;

// Reads the values of a scene and its world.
scree_status tuning_read(Tuning* tuning, const Scene* scene, const scree_world* world);

// Writes the values to a world and its scene. If a value is refused, both are unchanged.
scree_status tuning_write(const Tuning* tuning, Scene* scene, scree_world* world);

#endif
