// SPDX-License-Identifier: MIT
// shape_difference.h -- all differences of the points of two shapes, in double precision: their distance, and the first meeting of two that move.
//
// Two shapes overlap if a difference of their points is 0. The differences are a convex polygon with a radius, the sum of both radii. Its
// corners are among the differences of corners. So all corners are taken, and the hull around them is found without regard to angles.
#ifndef SHAPE_DIFFERENCE_H
#define SHAPE_DIFFERENCE_H
#include "scree/scree.h"

#define MOST_DIFFERENCES (SCREE_MAX_VERTICES * SCREE_MAX_VERTICES)

typedef struct
{
	double x[2 * MOST_DIFFERENCES], y[2 * MOST_DIFFERENCES]; // corners of the hull, counter-clockwise
	int count;
	double radius;
	double at_x, at_y; // the difference of the origins of the shapes
} Difference;

// b minus a, at their poses.
Difference difference_of(const scree_shape* a, scree_pose at_a, const scree_shape* b, scree_pose at_b);

// The distance of the surfaces after b moved by (x, y); negative if they overlap, -infinity never.
double difference_distance(const Difference* d, double x, double y);

// The share of the translation (x, y) of b at which the shapes meet, 0 if they do at once, 2 if they do not. Writes to margin, m, how far the
// path goes past the nearest point that makes it meet: a path that is moved by less meets them, too.
double difference_meeting(const Difference* d, double x, double y, double* margin);

// The least distance until a share of the translation.
double difference_least(const Difference* d, double x, double y, double share);

#endif
