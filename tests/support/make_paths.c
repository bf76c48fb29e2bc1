// SPDX-License-Identifier: MIT
// make_paths.c -- creates paths for tests, and bodies that move on paths.
#include "support/make_paths.h"
#include <math.h>

#define MOST_POINTS 256

scree_path add_path(scree_world* world, const scree_vec* points, int count, bool closed)
{
	scree_path_def def = scree_path_def_default();
	scree_path path;
	def.points = points;
	def.count = count;
	def.closed = closed;
	OK(scree_path_create(world, &def, &path));
	return path;
}

scree_path add_circle(scree_world* world, double radius, double x, double y, int count)
{
	scree_vec points[MOST_POINTS];
	assert_in_range(count, 3, MOST_POINTS);
	for (int k = 0; k < count; ++k)
	{
		double angle = 2.0 * PI * k / count - 0.5 * PI;
		points[k] = (scree_vec){(float)(x + radius * cos(angle)), (float)(y + radius * sin(angle))};
	}
	return add_path(world, points, count, true);
}

float length_of(scree_world* world, scree_path path)
{
	float length;
	OK(scree_path_get_length(world, path, &length));
	return length;
}

scree_pose pose_on_path(scree_world* world, scree_path path, float along)
{
	scree_pose pose;
	OK(scree_path_get_pose(world, path, along, &pose));
	return pose;
}

scree_body add_wagon(scree_world* world, scree_path path, float along, float half, float speed)
{
	scree_pose at = pose_on_path(world, path, along);
	scree_body body = add_box(world, SCREE_BODY_DYNAMIC, half, half, at.position.x, at.position.y);
	OK(scree_body_set_pose(world, body, at));
	throw_body(world, body, speed * at.rotation.c, speed * at.rotation.s, 0.0f);
	return body;
}

scree_joint_def path_def(scree_path path, scree_body a, scree_body b)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_PATH);
	def.body_a = a;
	def.body_b = b;
	def.path = path;
	return def;
}

scree_joint ride(scree_world* world, scree_path path, scree_body body, bool locked)
{
	scree_joint_def def = path_def(path, NOBODY, body);
	def.coordinates[SCREE_ANGLE].locked = locked;
	return add_joint(world, &def);
}
