// SPDX-License-Identifier: MIT
// geometry.h -- checks shapes, and computes normals, mass and reach from corners and radius.
#ifndef GEOMETRY_H
#define GEOMETRY_H
#include "world/check.h"

#define SMALLEST_SIZE 0.001f // m: minimum size of a shape
#define WELD_DISTANCE 0.005f // m: corners closer than this count as one corner; the limit is lower for small shapes
#define FLAT_DISTANCE 0.0005 // m: a corner closer than this to the line between its neighbors is flat; see tolerance_of

typedef struct // tolerances of a polygon, m: WELD_DISTANCE and FLAT_DISTANCE, or less if it is small
{
	double weld, flat;
} Tolerance;

// Returns the tolerances of a polygon. `weld` is a twentieth of the largest distance between two points, clamped to the
// range from 0.5 mm to WELD_DISTANCE; `flat` is a tenth of `weld`. An octagon with corners at SMALLEST_SIZE from its
// center has edges of 0.77 mm, so its corners are not welded.
Tolerance tolerance_of(const scree_vec* points, int count);

// Checks kind, count, radius and vertices of a shape, computes all other members, and clears vertices beyond count. Its
// tolerances are smaller than those of scree_shape_make_polygon, so a shape stays valid when rotated and translated.
scree_status shape_finish(ArgumentPlace at, scree_shape* shape);

// Computes the same members as shape_finish without checks. Reverses a clockwise polygon.
void shape_fill(scree_shape* shape);

// Fails unless corners form a convex polygon, in either direction, and none are too flat or too close together.
scree_status check_corners(const char* function, const char* argument, const scree_vec* v, int count,
                           Tolerance tolerance);

// Fails if coordinates are not finite, or beyond SCREE_MAX_COORDINATE.
scree_status check_points(const char* function, const char* argument, const scree_vec* v, int count);

// Fails unless the corners of a box are within SCREE_MAX_COORDINATE, and it is at least 2 mm wide and high.
scree_status check_box(const char* function, scree_box box);

static inline double vec_cross_from(scree_vec origin, scree_vec a, scree_vec b)
{
	return ((double)a.x - origin.x) * ((double)b.y - origin.y) - ((double)a.y - origin.y) * ((double)b.x - origin.x);
}

double vec_distance(scree_vec a, scree_vec b);
scree_vec pose_point(scree_pose pose, scree_vec point);

static inline scree_vec rot_vec(scree_rot rotation, scree_vec v)
{
	return pose_point((scree_pose){{0.0f, 0.0f}, rotation}, v);
}

// Returns the rotation by b followed by the rotation by a.
static inline scree_rot rot_product(scree_rot a, scree_rot b)
{
	return (scree_rot){a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
}

// Returns the world pose of `inner`, which is given in the frame of the pose `outer`.
static inline scree_pose pose_product(scree_pose outer, scree_pose inner)
{
	return (scree_pose){pose_point(outer, inner.position), rot_product(outer.rotation, inner.rotation)};
}

#endif
