// SPDX-License-Identifier: MIT
// live_tuning.h -- reads and writes parameters of a running world that the user can change: gravity, substeps, solver
// tuning.
#ifndef LIVE_TUNING_H
#define LIVE_TUNING_H
#include "scene/scene.h"

typedef struct
{
	bool changed; // true if the user changed a value; then the values stay when the scene restarts
	scree_vec gravity;
	int substeps;
	scree_tuning solver;
} Tuning;

// Reads gravity and solver tuning of a world, and the substeps of its scene.
scree_status tuning_read(Tuning* tuning, const Scene* scene, const scree_world* world);

// Writes solver tuning and gravity to a world, then substeps to its scene. Stops at the first value that is refused,
// and returns the error.
scree_status tuning_write(const Tuning* tuning, Scene* scene, scree_world* world);

#endif
