// SPDX-License-Identifier: MIT
// joint_support.h -- short ways to build and read joints, for their tests.
#ifndef JOINT_SUPPORT_H
#define JOINT_SUPPORT_H
#include "scree/scree.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

// Fails the test with the sentence of scree_error.
#define GOOD(call)                                                         \
	do                                                                     \
	{                                                                      \
		scree_status status_ = (call);                                     \
		if (status_ != SCREE_OK)                                           \
			fail_msg("%s: %s", scree_status_name(status_), scree_error()); \
	} while (0)

static const scree_body NOBODY = {0, 0};

// Rows of CHAIN_LEAST joints and more are solved together. Their translations are as stiff as at CHAIN_STIFFER times the frequency;
// angles are rigid.
#define CHAIN_LEAST   8
#define CHAIN_STIFFER 2.7173 // sqrt(4 (2 z + 4 h w) / (2 z + h w)) at 60 Hz, ratio z = 2, h = 1 / 240 s

// A definition between two bodies, whose frames lie at a pose in the world; either body may be null.
static inline scree_joint_def joint_def_at(scree_world* world, scree_joint_type type, scree_body a, scree_body b,
                                           float x, float y, float radians)
{
	scree_joint_def def = scree_joint_def_make(type);
	def.body_a = a;
	def.body_b = b;
	GOOD(scree_joint_def_place(world, &def, (scree_pose){{x, y}, scree_rot_make(radians)}));
	return def;
}

static inline scree_joint add_joint(scree_world* world, const scree_joint_def* def)
{
	scree_joint joint;
	GOOD(scree_joint_create(world, def, &joint));
	return joint;
}

// A joint with the defaults of its type.
static inline scree_joint join(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y)
{
	scree_joint_def def = joint_def_at(world, type, a, b, x, y, 0.0f);
	return add_joint(world, &def);
}

static inline scree_joint_state joint_state_of(scree_world* world, scree_joint joint)
{
	scree_joint_state state;
	GOOD(scree_joint_get_state(world, joint, &state));
	return state;
}

static inline int joint_events_of(scree_world* world, scree_joint_event* events, int capacity)
{
	int count;
	GOOD(scree_world_get_joint_events(world, events, capacity, &count));
	return count;
}

static inline int joints_of(scree_world* world)
{
	int count;
	GOOD(scree_world_get_joints(world, NULL, 0, &count));
	return count;
}

static inline scree_mass mass_of(scree_world* world, scree_body body)
{
	scree_mass mass;
	GOOD(scree_body_get_mass(world, body, &mass));
	return mass;
}

#endif
