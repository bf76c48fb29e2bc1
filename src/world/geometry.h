// SPDX-License-Identifier: MIT
// geometry.h -- shapes: what makes one sound, and what follows from its corners and radius.
#ifndef GEOMETRY_H
#define GEOMETRY_H
#include "world/check.h"

#define SMALLEST_SIZE 0.001f // m
#define WELD_DISTANCE 0.005f // m: corners closer than this are one
#define FLAT_DISTANCE 0.0005 // m: a corner less far from the line between its neighbors is none
#define HULL_POINTS   64     // most that scree_shape_make_hull takes

// Takes kind, count, radius and vertices of a shape that was made before, checks them and fills in everything else; the
// rest of the shape becomes zero. at.argument names the shape. Thresholds are lower than those of scree_shape_make_polygon,
// so that a shape which has been turned and shifted stays sound.
scree_status shape_finish(Where at, scree_shape* shape);

// The convex hull of 3 to 64 points, counter-clockwise, as indices into points; returns the number of corners, which is
// under 3 when the points lie on a line.
int hull_corners(const scree_vec* points, int count, int* corners);

static inline double vec_cross_from(scree_vec origin, scree_vec a, scree_vec b)
{
	return ((double)a.x - origin.x) * ((double)b.y - origin.y) - ((double)a.y - origin.y) * ((double)b.x - origin.x);
}

double vec_distance(scree_vec a, scree_vec b);
scree_vec pose_point(scree_pose pose, scree_vec point);

#endif
