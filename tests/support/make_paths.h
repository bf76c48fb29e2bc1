// SPDX-License-Identifier: MIT
// make_paths.h -- creates paths for tests, and bodies that move on paths.
#ifndef MAKE_PATHS_H
#define MAKE_PATHS_H
#include "support/make_joints.h"

scree_path add_path(scree_world* world, const scree_vec* points, int count, bool closed);

// Adds a closed path through points on a circle, counter-clockwise from the lowest point of the circle.
scree_path add_circle(scree_world* world, double radius, double x, double y, int count);

float length_of(scree_world* world, scree_path path);
scree_pose pose_on_path(scree_world* world, scree_path path, float along);

// Adds a box on a path. The box is aligned with the path and moves along it. along: arc length from the start of the
// path to the box, m. speed: in m/s.
scree_body add_wagon(scree_world* world, scree_path path, float along, float half, float speed);

scree_joint_def path_def(scree_path path, scree_body a, scree_body b);

// Adds a joint that holds the origin of a body on a path, which is fixed in the world.
scree_joint ride(scree_world* world, scree_path path, scree_body body, bool locked);

#endif
