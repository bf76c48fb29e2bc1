// SPDX-License-Identifier: MIT
// world_support.h -- worlds, boxes and what is read back of them, for the tests of the public interface.
#ifndef WORLD_SUPPORT_H
#define WORLD_SUPPORT_H
#include "world/world.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define STEP (1.0f / 60.0f)

static const char* device; // device of the worlds that the tests make

static inline void assert_ok(scree_status status)
{
	if (status != SCREE_OK)
		fail_msg("%s: %s", scree_status_name(status), scree_error());
}

static inline void assert_near(double value, double expected, double tolerance)
{
	if (!(fabs(value - expected) <= tolerance))
		fail_msg("%.9g is not %.9g within %g", value, expected, tolerance);
}

static inline scree_world* make_world(float gravity)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.threads = 2;
	def.gravity.y = gravity;
	scree_world* world;
	assert_ok(scree_world_create(&def, &world));
	return world;
}

static inline scree_attribute make_box(scree_world* world, float half_width, float half_height)
{
	scree_attribute_def def = scree_attribute_def_default();
	scree_attribute attribute;
	assert_ok(scree_shape_make_box(half_width, half_height, &def.shape));
	assert_ok(scree_attribute_create(world, &def, &attribute));
	return attribute;
}

static inline scree_body_def box_def(scree_world* world, scree_body_type type, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	def.attribute = make_box(world, 0.5f, 0.5f);
	return def;
}

static inline scree_body add_box(scree_world* world, scree_body_type type, float x, float y)
{
	scree_body_def def = box_def(world, type, x, y);
	scree_body body;
	assert_ok(scree_body_create(world, &def, &body));
	return body;
}

static inline void add_ground(scree_world* world)
{
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_STATIC;
	def.pose.position.y = -1.0f;
	def.attribute = make_box(world, 50.0f, 1.0f);
	assert_ok(scree_body_create(world, &def, NULL));
}

static inline void step(scree_world* world, int steps)
{
	for (int k = 0; k < steps; ++k)
		assert_ok(scree_world_step(world, STEP, 4));
}

static inline scree_pose pose_of(scree_world* world, scree_body body)
{
	scree_pose pose;
	assert_ok(scree_body_get_pose(world, body, &pose));
	return pose;
}

static inline scree_velocity velocity_of(scree_world* world, scree_body body)
{
	scree_velocity velocity;
	assert_ok(scree_body_get_velocity(world, body, &velocity));
	return velocity;
}

static inline uint64_t hash_of(scree_world* world)
{
	uint64_t hash;
	assert_ok(scree_world_get_hash(world, &hash));
	return hash;
}

static inline int contacts_of(scree_world* world)
{
	int count;
	assert_ok(scree_world_get_contacts(world, NULL, 0, &count));
	return count;
}

// The one collidable of a body.
static inline scree_collidable part_of(scree_world* world, scree_body body)
{
	scree_collidable part;
	int count;
	assert_ok(scree_body_get_collidables(world, body, &part, 1, &count));
	assert_int_equal(count, 1);
	return part;
}

static inline scree_pose pose_at(float x, float y, float radians)
{
	return (scree_pose){{x, y}, scree_rot_make(radians)};
}

static inline scree_counters counters_of(scree_world* world)
{
	scree_counters counters;
	assert_ok(scree_world_get_counters(world, &counters));
	return counters;
}

static inline int contacts_with(scree_world* world, scree_body body)
{
	int count;
	assert_ok(scree_body_get_contacts(world, body, NULL, 0, &count));
	return count;
}

// Both to the last bit.
static inline void assert_pose(scree_world* world, scree_body body, scree_pose expected)
{
	scree_pose pose = pose_of(world, body);
	assert_true(pose.position.x == expected.position.x && pose.position.y == expected.position.y);
	assert_true(pose.rotation.c == expected.rotation.c && pose.rotation.s == expected.rotation.s);
}

static inline void assert_velocity(scree_world* world, scree_body body, float x, float y, float w)
{
	scree_velocity v = velocity_of(world, body);
	assert_true(v.linear.x == x && v.linear.y == y && v.angular == w);
}

// A step of dt 0.
static inline void look(scree_world* world) { assert_ok(scree_world_step(world, 0.0f, 4)); }

static inline int use_cpu(void** state)
{
	(void)state;
	device = "cpu";
	return 0;
}

static inline int use_opencl(void** state)
{
	(void)state;
	device = "opencl";
	return 0;
}

static inline int memory_is_back(void** state)
{
	(void)state;
	return scree_memory() == 0 ? 0 : -1;
}

// Runs tests, an array of CMUnitTest, on the CPU, and again on OpenCL where there is a device. Returns the failures.
#define RUN_ON_DEVICES(tests)                                             \
	(cmocka_run_group_tests_name("cpu", tests, use_cpu, memory_is_back) + \
	 (scree_opencl_hint()[0] == '\0' ? cmocka_run_group_tests_name("opencl", tests, use_opencl, memory_is_back) : 0))

#endif
