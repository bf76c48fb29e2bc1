// SPDX-License-Identifier: MIT
// exact_shapes.h -- distances and meetings of shapes in double precision, computed from all pairs of corners and edges.
#ifndef EXACT_SHAPES_H
#define EXACT_SHAPES_H
#include "scree/scree.h"

typedef struct // corners and radius in world coordinates
{
	int count;
	double x[SCREE_MAX_VERTICES], y[SCREE_MAX_VERTICES], radius;
} Exact;

Exact exact_at(const scree_shape* shape, double x, double y, double c, double s);
Exact exact_moved(Exact e, double x, double y);

// Returns the distance of the surfaces, or minus the depth if the cores overlap.
double exact_distance(const Exact* a, const Exact* b);

// Returns the fraction at which b, which moves by (x, y), meets a; 2 if it does not. *least gets the smallest distance
// until then.
double exact_meeting(const Exact* a, const Exact* b, double x, double y, double* least);

#endif
