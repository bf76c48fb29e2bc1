// SPDX-License-Identifier: MIT
// shape_difference.h -- computes all differences of the points of two shapes, in double precision: the distance of the
// shapes, and their first meeting if one of them moves.
//
// Two shapes overlap if a difference of their points is 0. The differences are a convex polygon with a radius, which is
// the sum of both radii. Each corner of this polygon is a difference of two corners. So all differences of corners are
// computed, and the polygon is their hull, which needs no sorting by angle.
#ifndef SHAPE_DIFFERENCE_H
#define SHAPE_DIFFERENCE_H
#include "scree/scree.h"

#define MOST_DIFFERENCES (SCREE_MAX_VERTICES * SCREE_MAX_VERTICES)

typedef struct
{
	double x[2 * MOST_DIFFERENCES], y[2 * MOST_DIFFERENCES]; // corners of the hull, counter-clockwise
	int count;
	double radius;
	double at_x, at_y; // origin of b relative to that of a
} Difference;

// Returns the differences of the points of a and b, at their poses.
Difference difference_of(const scree_shape* a, scree_pose at_a, const scree_shape* b, scree_pose at_b);

// Returns the distance of the surfaces after b was moved by (x, y). Negative: the depth of an overlap; always finite.
double difference_distance(const Difference* d, double x, double y);

// Returns the share of the translation (x, y) of b at which the shapes meet: 0 if they overlap at the start, 2 if they
// never meet. Writes to *margin, m, the distance by which the path can be moved without losing the meeting.
double difference_meeting(const Difference* d, double x, double y, double* margin);

// Returns the least distance of the surfaces while b moves by this share of the translation.
double difference_least(const Difference* d, double x, double y, double share);

#endif
