// SPDX-License-Identifier: MIT
// ruler.c -- measures overlaps and contacts of poses, in the same way for all engines.
//
// Engines define separation differently: Box2D does not compute a manifold in every step. So the poses are copied into a Scree
// world, at rest and without gravity, which takes one very short step and then has the overlaps.
#include "ruler.h"
#include "scree_world.h"
#include <stdlib.h>

#define MOMENT 1.0e-4f // s: too short for bodies to move

bool ruler_open(Ruler* ruler, const Scene* scene)
{
	*ruler = (Ruler){.world = open_world(scene, "cpu", 0)};
	ruler->bodies = ruler->world ? list_bodies(ruler->world, &ruler->count) : NULL;
	if (!ruler->bodies)
		return false;
	size_t count = (size_t)ruler->count + 1;
	ruler->still = calloc(count, sizeof(scree_velocity));
	ruler->poses = calloc(count, sizeof(scree_pose));
	return ruler->still && ruler->poses && report(scree_world_set_gravity(ruler->world, (scree_vec){0.0f, 0.0f}));
}

static bool measure_heights(Ruler* ruler)
{
	bool first = !ruler->height;
	if (first)
		ruler->height = calloc((size_t)ruler->count + 1, sizeof(float));
	if (!ruler->height)
		return false;
	ruler->sunk = 0.0f;
	for (int k = 0; k < ruler->count; ++k)
	{
		float height = ruler->poses[k].position.y;
		if (first)
			ruler->height[k] = height;
		if (ruler->height[k] - height > ruler->sunk)
			ruler->sunk = ruler->height[k] - height;
	}
	return true;
}

bool ruler_measure(Ruler* ruler)
{
	scree_counters counters;
	if (!measure_heights(ruler) ||
	    !report(scree_bodies_set_poses(ruler->world, ruler->bodies, ruler->poses, ruler->count)) ||
	    !report(scree_bodies_set_velocities(ruler->world, ruler->bodies, ruler->still, ruler->count)) ||
	    !report(scree_world_step(ruler->world, MOMENT, 1)) ||
	    !report(scree_world_get_counters(ruler->world, &counters)))
		return false;
	if (counters.penetration > ruler->penetration)
		ruler->penetration = counters.penetration;
	ruler->depths += (double)counters.penetration;
	ruler->contacts += counters.touching;
	++ruler->measured;
	return true;
}

void ruler_close(Ruler* ruler)
{
	scree_world_destroy(ruler->world);
	free(ruler->bodies);
	free(ruler->still);
	free(ruler->poses);
	free(ruler->height);
}
