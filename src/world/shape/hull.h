// SPDX-License-Identifier: MIT
// hull.h -- the convex hull of a few points.
#ifndef HULL_H
#define HULL_H
#include "scree/scree.h"

#define HULL_POINTS 64 // maximum number of points of scree_shape_make_hull

// Finds the hull of 3 to 64 points as indices, counter-clockwise. Returns their number, under 3 for points on a line.
int hull_corners(const scree_vec* points, int count, int* corners);

#endif
