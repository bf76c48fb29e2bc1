// SPDX-License-Identifier: MIT
// convex_sum.h -- computes the Minkowski sum of the core of a shape and the mirrored core of another one.
//
// The edges of the sum are those of both cores, sorted by angle (Mark de Berg et al., Computational Geometry, 2008,
// theorem 13.11).
#ifndef CONVEX_SUM_H
#define CONVEX_SUM_H
#include "stages/geometry/convex.h"

#define SUM_CORNERS (2 * MAX_CORNERS)

#define SUM_PARALLEL 2e-7f // maximum sine of the angle between two edges that are merged
#define SUM_FLAT     1e-4f // maximum sine of the angle between two segments whose sum counts as without area

// source of an edge of a sum: the core to which the edge belongs, or both cores
#define SUM_OF_A    1
#define SUM_OF_B    2
#define SUM_OF_BOTH 3

typedef struct // Minkowski sum, in the frame of shape a
{
	Vec corners[SUM_CORNERS], normals[SUM_CORNERS];
	Word parts[SUM_CORNERS]; // bits 0-7: corner of shape a; 8-15: of shape b; from 16 on: SUM_OF_* of edge k
	int count, thin;
} Sum;

// Returns the first corner of a core whose edges are sorted by angle: the lowest corner or, of two equally low ones,
// the left one. turn: rotation of the core. sign: 1, or -1 for the mirror image of the core.
INLINE int sum_first(const GLOBAL Attribute* shape, Vec turn, float sign)
{
	int first = 0;
	Vec lowest = vec_scale(sign, vec_turn(turn, shape_corner(shape, 0)));
	for (int k = 1; k < shape->count; ++k)
	{
		Vec v = vec_scale(sign, vec_turn(turn, shape_corner(shape, k)));
		if (v.y < lowest.y || (v.y == lowest.y && v.x < lowest.x))
		{
			lowest = v;
			first = k;
		}
	}
	return first;
}

// Returns the source of a sum's next edge: the core whose next edge has the smaller angle, or both. a, b: next edges.
INLINE Word sum_turn(Vec a, Vec b)
{
	Real cross = vec_cross(a, b), dot = vec_dot(a, b);
	Real bound = SUM_PARALLEL * root(vec_dot(a, a) * vec_dot(b, b));
	if (dot > 0.0f && absolute(cross) <= bound)
		return SUM_OF_BOTH;
	if (cross == 0.0f)
		return a.y > 0.0f || (a.y == 0.0f && a.x > 0.0f) ? SUM_OF_A : SUM_OF_B;
	return cross > 0.0f ? SUM_OF_A : SUM_OF_B;
}

// Computes the sum of shape a and the mirror image of shape b. turn: rotation of shape b in the frame of shape a.
INLINE void sum_make(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Vec turn, Sum* sum)
{
	int edges_a = a->count > 1 ? a->count : 0, edges_b = b->count > 1 ? b->count : 0;
	int i = sum_first(a, vec(1.0f, 0.0f), 1.0f), j = sum_first(b, turn, -1.0f), count = 0;
	Vec at_a = shape_corner(a, i), at_b = vec_turn(turn, shape_corner(b, j));
	while (edges_a + edges_b > 0)
	{
		Vec then_a = at_a, then_b = at_b;
		if (edges_a > 0)
			then_a = shape_corner(a, shape_next(a, i));
		if (edges_b > 0)
			then_b = vec_turn(turn, shape_corner(b, shape_next(b, j)));
		Word part = edges_b == 0   ? SUM_OF_A
		            : edges_a == 0 ? SUM_OF_B
		                           : sum_turn(vec_sub(then_a, at_a), vec_sub(at_b, then_b));
		sum->corners[count] = vec_sub(at_a, at_b);
		sum->normals[count] = part & SUM_OF_A ? shape_normal(a, i) : vec_neg(vec_turn(turn, shape_normal(b, j)));
		sum->parts[count] = (Word)i | (Word)j << 8 | part << 16;
		++count;
		if (part & SUM_OF_A)
		{
			i = shape_next(a, i);
			at_a = then_a;
			--edges_a;
		}
		if (part & SUM_OF_B)
		{
			j = shape_next(b, j);
			at_b = then_b;
			--edges_b;
		}
	}
	if (count == 0)
	{
		sum->corners[0] = vec_sub(at_a, at_b);
		sum->normals[0] = vec(0.0f, 1.0f);
		sum->parts[0] = 0;
		count = 1;
	}
	sum->count = count;
	sum->thin = count < 3;
	if (a->count == 2 && b->count == 2 && count == 4)
		sum->thin = absolute(vec_cross(shape_normal(a, 0), vec_turn(turn, shape_normal(b, 0)))) <= SUM_FLAT;
}

INLINE Convex sum_convex(const Sum* sum, Real radius)
{
	Convex c;
	c.shape = 0;
	c.corners = sum->corners;
	c.normals = sum->normals;
	c.count = sum->count;
	c.thin = sum->thin;
	c.radius = radius;
	return c;
}

// Returns the point of shape a's surface that is nearest to shape b. The shapes do not overlap. edge, corner, normal:
// edge of the sum, corner or -1, and normal, from convex_nearest. q: origin of shape b in the frame of shape a.
INLINE Vec sum_point(const Sum* sum, const GLOBAL Attribute* a, const GLOBAL Attribute* b, Vec turn, Vec q, int edge,
                     int corner, Vec normal)
{
	Word part = sum->parts[corner < 0 ? edge : corner];
	int i = (int)(part & 255), j = (int)(part >> 8 & 255);
	Vec core = shape_corner(a, i);
	if (corner < 0 && part >> 16 & SUM_OF_A)
	{
		Vec along = vec(-normal.y, normal.x), of_b = vec_add(q, vec_turn(turn, shape_corner(b, j)));
		Real length = vec_dot(vec_sub(shape_corner(a, shape_next(a, i)), core), along);
		Real at = minimum(maximum(vec_dot(vec_sub(of_b, core), along), 0.0f), length);
		core = vec_add(core, vec_scale(at, along));
	}
	return vec_add(core, vec_scale(a->radius, normal));
}

#endif
