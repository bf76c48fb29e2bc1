// SPDX-License-Identifier: MIT
// make_joints.c -- creates joints for tests, and reads their state.
#include "support/make_joints.h"
#include <math.h>
#include <stdlib.h>

scree_joint_def joint_def_at(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y,
                             float radians)
{
	scree_joint_def def = scree_joint_def_make(type);
	def.body_a = a;
	def.body_b = b;
	OK(scree_joint_def_place(world, &def, pose_at(x, y, radians)));
	return def;
}

scree_joint add_joint(scree_world* world, const scree_joint_def* def)
{
	scree_joint joint;
	OK(scree_joint_create(world, def, &joint));
	return joint;
}

scree_joint join(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y)
{
	scree_joint_def def = joint_def_at(world, type, a, b, x, y, 0.0f);
	return add_joint(world, &def);
}

scree_joint couple(scree_world* world, scree_joint_def* def)
{
	OK(scree_joint_def_couple(world, def));
	return add_joint(world, def);
}

scree_joint_state joint_state_of(scree_world* world, scree_joint joint)
{
	scree_joint_state state;
	OK(scree_joint_get_state(world, joint, &state));
	return state;
}

int joint_events_of(scree_world* world, scree_joint_event* events, int capacity)
{
	int count;
	OK(scree_world_get_joint_events(world, events, capacity, &count));
	return count;
}

int joints_of(scree_world* world)
{
	int count;
	OK(scree_world_get_joints(world, NULL, 0, &count));
	return count;
}

double joint_gap_of(scree_world* world)
{
	int count = joints_of(world);
	scree_joint* joints = calloc((size_t)count + 1, sizeof *joints);
	scree_joint_state* states = calloc((size_t)count + 1, sizeof *states);
	assert_true(joints && states);
	double gap = 0.0;
	OK(scree_world_get_joints(world, joints, count, &count));
	OK(scree_joints_get_states(world, joints, states, count));
	for (int k = 0; k < count; ++k)
		if (!states[k].broken)
			gap = fmax(gap, hypot(states[k].values[0], states[k].values[1]));
	free(joints);
	free(states);
	return gap;
}
