// SPDX-License-Identifier: MIT
// ruler.c -- overlaps and contacts of a set of poses, measured by one rule whichever engine they come from.
//
// Engines differ in what they call a separation: Box2D keeps a manifold for a while without looking again. So neither
// is asked. The poses are put into a Scree world of their own, at rest and without gravity, and one very short step says
// what overlaps there.
#include "ruler.h"
#include "engine.h"
#include <stdlib.h>

#define MOMENT 1.0e-4f // s: nothing moves in it

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

static bool note_heights(Ruler* ruler)
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
	if (!note_heights(ruler) ||
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
