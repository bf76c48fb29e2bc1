// SPDX-License-Identifier: MIT
// measure.c -- measures the overlaps, contacts and joint errors of poses, in the same way for all engines.
//
// Engines define separation differently, and Box2D does not compute a manifold in every step. So the poses are copied
// into a Scree world, at rest and without gravity. After one very short step that world has the overlaps and contacts.
#include "measure.h"
#include "validate/scree_world.h"
#include <math.h>
#include <stdlib.h>

#define MOMENT 1.0e-4f // s: too short for bodies to move

static bool find_locks(Measure* measure)
{
	for (int k = 0; k < measure->joint_count; ++k)
	{
		scree_joint_def def;
		if (!report_status(scree_joint_get_def(measure->world, measure->joints[k], &def)))
			return false;
		for (int c = SCREE_ALONG; c <= SCREE_ACROSS; ++c)
		{
			measure->locks[k].locked[c] = def.coordinates[c].locked;
			measure->locks[k].target[c] = def.coordinates[c].target;
		}
	}
	return true;
}

// Lists the bodies and joints of the world, and allocates arrays of their sizes.
static bool list(Measure* measure)
{
	free(measure->bodies);
	free(measure->still);
	free(measure->poses);
	free(measure->joints);
	free(measure->states);
	free(measure->locks);
	measure->bodies = list_bodies(measure->world, &measure->count);
	measure->joints = list_joints(measure->world, &measure->joint_count);
	size_t count = (size_t)measure->count + 1, joints = (size_t)measure->joint_count + 1;
	measure->still = calloc(count, sizeof(scree_velocity));
	measure->poses = calloc(count, sizeof(scree_pose));
	measure->states = calloc(joints, sizeof(scree_joint_state));
	measure->locks = calloc(joints, sizeof(MeasureLock));
	return measure->bodies && measure->joints && measure->still && measure->poses && measure->states &&
	       measure->locks && find_locks(measure);
}

bool measure_open(Measure* measure, const Setup* setup)
{
	*measure = (Measure){.world = setup_open(setup, 0)};
	return measure->world && list(measure) &&
	       report_status(scree_world_set_gravity(measure->world, (scree_vec){0.0f, 0.0f}));
}

// Does nothing for a scene in a file, because bodies that the scene replaces keep their places in the list.
bool measure_change(Measure* measure, const Setup* setup, int64_t step)
{
	return setup->scene || !setup->fixture->change || (setup_change(setup, measure->world, step) && list(measure));
}

static bool measure_heights(Measure* measure)
{
	bool first = !measure->height;
	if (first)
	{
		measure->heights = measure->count;
		measure->height = calloc((size_t)measure->count + 1, sizeof(float));
	}
	if (!measure->height)
		return false;
	measure->sunk = 0.0f;
	for (int k = 0; k < measure->heights; ++k)
	{
		float height = measure->poses[k].position.y;
		if (first)
			measure->height[k] = height;
		if (measure->height[k] - height > measure->sunk)
			measure->sunk = measure->height[k] - height;
	}
	return true;
}

static bool measure_joints(Measure* measure)
{
	if (!report_status(scree_joints_get_states(measure->world, measure->joints, measure->states, measure->joint_count)))
		return false;
	for (int k = 0; k < measure->joint_count; ++k)
	{
		const float* values = measure->states[k].values;
		const MeasureLock* lock = &measure->locks[k];
		float error[2];
		if (!lock->locked[SCREE_ALONG] && !lock->locked[SCREE_ACROSS])
			continue;
		for (int c = SCREE_ALONG; c <= SCREE_ACROSS; ++c)
			error[c] = lock->locked[c] ? values[c] - lock->target[c] : 0.0f;
		float gap = hypotf(error[SCREE_ALONG], error[SCREE_ACROSS]);
		measure->separation = gap > measure->separation ? gap : measure->separation;
		measure->gaps += (double)gap;
		measure->gauged += 1.0;
	}
	return true;
}

double measure_gap(const Measure* measure) { return measure->gauged > 0.0 ? measure->gaps / measure->gauged : 0.0; }

bool measure_take(Measure* measure)
{
	scree_counters counters;
	if (!measure_heights(measure) ||
	    !report_status(scree_bodies_set_poses(measure->world, measure->bodies, measure->poses, measure->count)) ||
	    !report_status(scree_bodies_set_velocities(measure->world, measure->bodies, measure->still, measure->count)) ||
	    !measure_joints(measure) || !report_status(scree_world_step(measure->world, MOMENT, 1)) ||
	    !report_status(scree_world_get_counters(measure->world, &counters)))
		return false;
	if (counters.penetration > measure->penetration)
		measure->penetration = counters.penetration;
	measure->depths += (double)counters.penetration;
	measure->contacts += counters.touching;
	++measure->measured;
	return true;
}

void measure_close(Measure* measure)
{
	scree_world_destroy(measure->world);
	free(measure->bodies);
	free(measure->still);
	free(measure->poses);
	free(measure->height);
	free(measure->joints);
	free(measure->states);
	free(measure->locks);
}
