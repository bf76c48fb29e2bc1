// SPDX-License-Identifier: MIT
// exact_shapes.h -- computes distances and meetings of shapes in double precision, from all pairs of corners and edges.
#ifndef EXACT_SHAPES_H
#define EXACT_SHAPES_H
#include "scree/scree.h"

typedef struct // a shape: its corners in world coordinates, and its radius
{
	int count;
	double x[SCREE_MAX_VERTICES], y[SCREE_MAX_VERTICES], radius;
} Exact;

Exact exact_at(const scree_shape* shape, double x, double y, double c, double s);
Exact exact_moved(Exact e, double x, double y);

// Returns the distance between the surfaces of two shapes. If the shapes overlap, it is negative: minus the depth.
double exact_distance(const Exact* a, const Exact* b);

// Moves shape b by (x, y). Returns the fraction of this displacement at which shape b meets shape a, or 2 if they do
// not meet. *least: smallest distance between the shapes during the motion, not above 0 if they meet.
double exact_meeting(const Exact* a, const Exact* b, double x, double y, double* least);

#endif
