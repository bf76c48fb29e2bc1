// SPDX-License-Identifier: MIT
// measure.c -- measures overlaps, contacts and joints of poses, in the same way for all engines.
//
// Engines define separation differently: Box2D does not compute a manifold in every step. So the poses are copied into a Scree
// world, at rest and without gravity, which takes one very short step and then has the overlaps.
#include "measure.h"
#include "scree_world.h"
#include <math.h>
#include <stdlib.h>

#define MOMENT 1.0e-4f // s: too short for bodies to move

static bool find_locks(Ruler* ruler)
{
	for (int k = 0; k < ruler->joint_count; ++k)
	{
		scree_joint_def def;
		if (!report(scree_joint_get_def(ruler->world, ruler->joints[k], &def)))
			return false;
		for (int c = SCREE_ALONG; c <= SCREE_ACROSS; ++c)
		{
			ruler->locks[k].locked[c] = def.coordinates[c].locked;
			ruler->locks[k].target[c] = def.coordinates[c].target;
		}
	}
	return true;
}

// Lists what the world has.
static bool list(Ruler* ruler)
{
	free(ruler->bodies);
	free(ruler->still);
	free(ruler->poses);
	free(ruler->joints);
	free(ruler->states);
	free(ruler->locks);
	ruler->bodies = list_bodies(ruler->world, &ruler->count);
	ruler->joints = list_joints(ruler->world, &ruler->joint_count);
	size_t count = (size_t)ruler->count + 1, joints = (size_t)ruler->joint_count + 1;
	ruler->still = calloc(count, sizeof(scree_velocity));
	ruler->poses = calloc(count, sizeof(scree_pose));
	ruler->states = calloc(joints, sizeof(scree_joint_state));
	ruler->locks = calloc(joints, sizeof(RulerLock));
	return ruler->bodies && ruler->joints && ruler->still && ruler->poses && ruler->states && ruler->locks &&
	       find_locks(ruler);
}

bool ruler_open(Ruler* ruler, const Setup* setup)
{
	*ruler = (Ruler){.world = setup_open(setup, "cpu", 0)};
	return ruler->world && list(ruler) && report(scree_world_set_gravity(ruler->world, (scree_vec){0.0f, 0.0f}));
}

// Bodies that a scene in a file replaces keep their place in the list.
bool ruler_change(Ruler* ruler, const Setup* setup, int64_t step)
{
	return setup->scene || !setup->rig->change || (setup_change(setup, ruler->world, step) && list(ruler));
}

static bool measure_heights(Ruler* ruler)
{
	bool first = !ruler->height;
	if (first)
	{
		ruler->heights = ruler->count;
		ruler->height = calloc((size_t)ruler->count + 1, sizeof(float));
	}
	if (!ruler->height)
		return false;
	ruler->sunk = 0.0f;
	for (int k = 0; k < ruler->heights; ++k)
	{
		float height = ruler->poses[k].position.y;
		if (first)
			ruler->height[k] = height;
		if (ruler->height[k] - height > ruler->sunk)
			ruler->sunk = ruler->height[k] - height;
	}
	return true;
}

static bool measure_joints(Ruler* ruler)
{
	if (!report(scree_joints_get_states(ruler->world, ruler->joints, ruler->states, ruler->joint_count)))
		return false;
	for (int k = 0; k < ruler->joint_count; ++k)
	{
		const float* values = ruler->states[k].values;
		const RulerLock* lock = &ruler->locks[k];
		float error[2];
		if (!lock->locked[SCREE_ALONG] && !lock->locked[SCREE_ACROSS])
			continue;
		for (int c = SCREE_ALONG; c <= SCREE_ACROSS; ++c)
			error[c] = lock->locked[c] ? values[c] - lock->target[c] : 0.0f;
		float gap = hypotf(error[SCREE_ALONG], error[SCREE_ACROSS]);
		ruler->separation = gap > ruler->separation ? gap : ruler->separation;
		ruler->gaps += (double)gap;
		ruler->gauged += 1.0;
	}
	return true;
}

double ruler_gap(const Ruler* ruler) { return ruler->gauged > 0.0 ? ruler->gaps / ruler->gauged : 0.0; }

bool ruler_measure(Ruler* ruler)
{
	scree_counters counters;
	if (!measure_heights(ruler) ||
	    !report(scree_bodies_set_poses(ruler->world, ruler->bodies, ruler->poses, ruler->count)) ||
	    !report(scree_bodies_set_velocities(ruler->world, ruler->bodies, ruler->still, ruler->count)) ||
	    !measure_joints(ruler) || !report(scree_world_step(ruler->world, MOMENT, 1)) ||
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
	free(ruler->joints);
	free(ruler->states);
	free(ruler->locks);
}
