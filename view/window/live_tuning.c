// SPDX-License-Identifier: MIT
// live_tuning.c -- reads and writes parameters of a running world that the user can change: gravity, substeps, solver
// tuning.
#include "view/window/live_tuning.h"

scree_status tuning_read(Tuning* tuning, const Scene* scene, const scree_world* world)
{
	tuning->changed = false;
	tuning->substeps = scene->substeps;
	scree_status status = scree_world_get_gravity(world, &tuning->gravity);
	return status == SCREE_OK ? scree_world_get_tuning(world, &tuning->solver) : status;
}

scree_status tuning_write(const Tuning* tuning, Scene* scene, scree_world* world)
{
	scree_status status = scree_world_set_tuning(world, &tuning->solver);
	if (status == SCREE_OK)
		status = scree_world_set_gravity(world, tuning->gravity);
	if (status == SCREE_OK)
		scene->substeps = tuning->substeps;
	return status;
}
