// SPDX-License-Identifier: MIT
// hull.h -- computes the convex hull of a few points.
#ifndef HULL_H
#define HULL_H
#include "scree/scree.h"

#define HULL_POINTS 64 // maximum number of points of scree_shape_make_hull

// Finds the corners of the hull of 3 to 64 points, as indices of points, counter-clockwise. Returns their number, which
// is less than 3 if the points are on a line or too close together.
int hull_corners(const scree_vec* points, int count, int* corners);

#endif
