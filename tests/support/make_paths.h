// SPDX-License-Identifier: MIT
// make_paths.h -- paths of tests, and bodies that run on them.
#ifndef MAKE_PATHS_H
#define MAKE_PATHS_H
#include "support/make_joints.h"

scree_path add_path(scree_world* world, const scree_vec* points, int count, bool closed);

// A circle through some points, counter-clockwise, from its lowest point on.
scree_path add_circle(scree_world* world, double radius, double x, double y, int count);

float length_of(scree_world* world, scree_path path);
scree_pose pose_on_path(scree_world* world, scree_path path, float along);

// A box that lies on a path in the world at an arc length, along it and with a speed along it.
scree_body add_wagon(scree_world* world, scree_path path, float along, float half, float speed);

scree_joint_def path_def(scree_path path, scree_body a, scree_body b);

// Holds the origin of a body on a path in the world.
scree_joint ride(scree_world* world, scree_path path, scree_body body, bool locked);

#endif
