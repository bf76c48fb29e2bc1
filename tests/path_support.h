// SPDX-License-Identifier: MIT
// path_support.h -- short ways to build paths and what runs on them, for their tests.
#ifndef PATH_SUPPORT_H
#define PATH_SUPPORT_H
#include "joint_support.h"
#include "support.h"

#define G 10.0 // m/s^2

static inline scree_path add_path(scree_world* world, const scree_vec* points, int count, bool closed)
{
	scree_path_def def = scree_path_def_default();
	scree_path path;
	def.points = points;
	def.count = count;
	def.closed = closed;
	GOOD(scree_path_create(world, &def, &path));
	return path;
}

#define MOST_POINTS 256

// Adds a circle through count points, counter-clockwise, from its lowest point on.
static inline scree_path add_circle(scree_world* world, double radius, double x, double y, int count)
{
	scree_vec points[MOST_POINTS];
	for (int k = 0; k < count; ++k)
	{
		double angle = 2.0 * PI * k / count - 0.5 * PI;
		points[k] = (scree_vec){(float)(x + radius * cos(angle)), (float)(y + radius * sin(angle))};
	}
	return add_path(world, points, count, true);
}

static inline float length_of(scree_world* world, scree_path path)
{
	float length;
	GOOD(scree_path_get_length(world, path, &length));
	return length;
}

static inline scree_pose pose_at(scree_world* world, scree_path path, float along)
{
	scree_pose pose;
	GOOD(scree_path_get_pose(world, path, along, &pose));
	return pose;
}

// A box that lies on a path in the world at an arc length, along it and with a speed along it.
static inline scree_body add_wagon(scree_world* world, scree_path path, float along, float half, float speed)
{
	scree_pose at = pose_at(world, path, along);
	scree_body body = add_box(world, SCREE_BODY_DYNAMIC, half, half, at.position.x, at.position.y);
	GOOD(scree_body_set_pose(world, body, at));
	GOOD(scree_body_set_velocity(world, body, (scree_velocity){{speed * at.rotation.c, speed * at.rotation.s}, 0.0f}));
	return body;
}

static inline scree_joint_def path_def(scree_path path, scree_body a, scree_body b)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
	def.body_a = a;
	def.body_b = b;
	def.path = path;
	return def;
}

// Holds the origin of a body on a path in the world.
static inline scree_joint ride(scree_world* world, scree_path path, scree_body body, bool locked)
{
	scree_joint_def def = path_def(path, NOBODY, body);
	def.coordinates[SCREE_ANGLE].locked = locked;
	return add_joint(world, &def);
}

#endif
