// SPDX-License-Identifier: MIT
// live_tuning.h -- what the user changes of a running world: gravity, substeps, how the solver is tuned.
#ifndef LIVE_TUNING_H
#define LIVE_TUNING_H
#include "scene/scene.h"

typedef struct
{
	bool changed; // by the user: it is kept when the scene restarts
	scree_vec gravity;
	int substeps;
	scree_tuning solver;
} Tuning;

// Reads what a scene has made.
scree_status tuning_read(Tuning* tuning, const Scene* scene, const scree_world* world);

// Writes it to a world and its scene; they stay as they are if a value is refused.
scree_status tuning_write(const Tuning* tuning, Scene* scene, scree_world* world);

#endif
