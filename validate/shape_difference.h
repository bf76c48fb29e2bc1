// SPDX-License-Identifier: MIT
// shape_difference.h -- computes the Minkowski difference of two shapes in double precision, and from it their distance
// and, if one of the shapes moves, their first meeting.
//
// The Minkowski difference is the set of all differences of a point of one shape and a point of the other; shapes
// overlap if it contains 0. It is a convex polygon with a radius, the sum of both radii. Each of its corners is a
// difference of two corners, so the polygon is the hull of all differences of corners.
#ifndef SHAPE_DIFFERENCE_H
#define SHAPE_DIFFERENCE_H
#include "scree/scree.h"

#define MOST_DIFFERENCES (SCREE_MAX_VERTICES * SCREE_MAX_VERTICES)

typedef struct
{
	double x[2 * MOST_DIFFERENCES], y[2 * MOST_DIFFERENCES]; // corners of the hull, counter-clockwise
	int count;
	double radius;
	double at_x, at_y; // m: origin of shape b relative to the origin of shape a
} Difference;

// Returns the Minkowski difference of shapes a and b, at the poses at_a and at_b.
Difference difference_of(const scree_shape* a, scree_pose at_a, const scree_shape* b, scree_pose at_b);

// Returns the distance between the surfaces, m, after shape b is moved by (x, y). The distance is finite. If the shapes
// overlap, returns minus the depth of the overlap.
double difference_distance(const Difference* d, double x, double y);

// Returns the share of the translation (x, y) of shape b at which the shapes meet: 0 if they overlap at the start, 2 if
// they never meet. Writes to *margin the distance, m, by which the path can be moved without losing the meeting; at
// most 0 if the shapes never meet.
double difference_meeting(const Difference* d, double x, double y, double* margin);

// Returns the minimum distance between the surfaces, m, while shape b moves by this share of the translation (x, y).
double difference_least(const Difference* d, double x, double y, double share);

#endif
