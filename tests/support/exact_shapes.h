// SPDX-License-Identifier: MIT
// exact_shapes.h -- distances and meetings of shapes in double precision, by trying all pairs of corners and edges.
#ifndef EXACT_SHAPES_H
#define EXACT_SHAPES_H
#include "scree/scree.h"

typedef struct // in the world
{
	int count;
	double x[SCREE_MAX_VERTICES], y[SCREE_MAX_VERTICES], radius;
} Exact;

Exact exact_at(const scree_shape* shape, double x, double y, double c, double s);
Exact exact_moved(Exact e, double x, double y);

// The distance of the surfaces; where the cores overlap, minus the depth.
double exact_distance(const Exact* a, const Exact* b);

// The fraction at which b, moving along a path (x, y), meets a; 2 if it does not. *least is the least distance until then.
double exact_meeting(const Exact* a, const Exact* b, double x, double y, double* least);

#endif
