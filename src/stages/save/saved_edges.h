// SPDX-License-Identifier: MIT
// saved_edges.h -- computes the manifold of two shapes from their edges, for several contacts at once.
//
// The operations and their order are those of edge_manifold, without the choice of the edges. A save compares the result
// with the manifold that it stands for, so a difference would only make saves larger.
#ifndef SAVED_EDGES_H
#define SAVED_EDGES_H
#include "dialect/finite.h"
#include "pools/pools.h"

// Members of an attribute after its corners and normals, in the order of a row of eight.
#define TRAIT_RADIUS      0
#define TRAIT_COUNT       1
#define TRAIT_FRICTION    2
#define TRAIT_RESTITUTION 3
#define TRAIT_ROLLING     4
#define TRAIT_SPEED       5
#define TRAIT_REACH       7
#define ATTRIBUTE_ROWS    5 // number of rows of eight in an attribute: corners, normals, traits

typedef struct // both ends of the incident edge, after it was clipped: points of the manifold if they are near enough
{
	Vec normal, point[2];
	Real separation[2];
	Int feature[2];
} SavedEnds;

typedef struct // the two shapes, and the pair of edges
{
	Int a, b;              // attributes
	Real at_a[8], at_b[8]; // their traits
	Int swap;              // mask: the reference edge is that of shape b
	Int edge, other;       // numbers of the reference edge and of the incident edge
} SavedEdges;

// Sets the attributes of the shapes, and their traits.
OUT_OF_LINE void saved_shapes(const Pools* p, SavedEdges* e, Int a, Int b)
{
	e->a = a;
	e->b = b;
	gather_fixed_rows8((const GLOBAL float*)p->attribute, a * ATTRIBUTE_ROWS + (ATTRIBUTE_ROWS - 1), e->at_a);
	gather_fixed_rows8((const GLOBAL float*)p->attribute, b * ATTRIBUTE_ROWS + (ATTRIBUTE_ROWS - 1), e->at_b);
}

// Returns corner k of a shape, or normal k - MAX_CORNERS.
INLINE Vec saved_vec(const Pools* p, Int shape, Int k)
{
	Vec v;
	gather_pairs((const GLOBAL float*)p->attribute, shape * (ATTRIBUTE_ROWS * 4) + k, &v.x, &v.y);
	return v;
}

// Returns the manifold. position, rotation: pose of shape b in the frame of shape a.
OUT_OF_LINE SavedEnds saved_ends(const Pools* p, SavedEdges e, Vec position, Vec rotation)
{
	SavedEnds ends;
	Int reference = blend_int(e.a, e.b, e.swap), incident = blend_int(e.b, e.a, e.swap);
	Vec at = vec_blend(position, vec_neg(vec_turn_back(rotation, position)), e.swap);
	Vec turn = vec(rotation.x, blend(rotation.y, -rotation.y, e.swap));
	Int count_a = real_bits(e.at_a[TRAIT_COUNT]), count_b = real_bits(e.at_b[TRAIT_COUNT]), zero_int = e.a & 0;
	Int next = e.edge + 1, other_next = e.other + 1;
	next = blend_int(zero_int, next, next < blend_int(count_a, count_b, e.swap));
	other_next = blend_int(zero_int, other_next, other_next < blend_int(count_b, count_a, e.swap));
	Vec origin = saved_vec(p, reference, e.edge), up = saved_vec(p, reference, e.edge + MAX_CORNERS);
	Vec right = vec(-up.y, up.x);
	Real length = vec_dot(vec_sub(saved_vec(p, reference, next), origin), right);
	Real facing = vec_dot(vec_turn_back(turn, up), saved_vec(p, incident, e.other + MAX_CORNERS));
	Vec start = vec_sub(vec_add(at, vec_turn(turn, saved_vec(p, incident, e.other))), origin);
	Vec end = vec_sub(vec_add(at, vec_turn(turn, saved_vec(p, incident, other_next))), origin);
	Vec high = vec(vec_dot(start, right), vec_dot(start, up)), low = vec(vec_dot(end, right), vec_dot(end, up));

	Real zero = splat(0.0f);
	Int overlap = (high.x >= zero) & (low.x <= length);
	Int cut_high = overlap & (high.x > length), cut_low = overlap & (low.x < zero);
	Vec along = vec_sub(low, high);
	Vec high_cut = vec(length, high.y + quotient(high.x - length, -along.x) * along.y);
	Vec low_cut = vec(zero, low.y + quotient(low.x, along.x) * -along.y);
	high = vec_blend(high, high_cut, cut_high);
	low = vec_blend(low, low_cut, cut_low);

	Real radius = blend(e.at_a[TRAIT_RADIUS], e.at_b[TRAIT_RADIUS], e.swap);
	Real other = blend(e.at_b[TRAIT_RADIUS], e.at_a[TRAIT_RADIUS], e.swap);
	Int steep = facing > splat(-FACING);
	Int on_reference[2] = {blend_int(next, e.edge + FEATURE_EDGE, steep & (cut_high == 0)),
	                       blend_int(e.edge, e.edge + FEATURE_EDGE, steep & (cut_low == 0))};
	Int on_incident[2] = {blend_int(e.other, e.other + FEATURE_EDGE, steep & cut_high),
	                      blend_int(other_next, e.other + FEATURE_EDGE, steep & cut_low)};
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		Vec of = k ? low : high;
		Vec from = vec_add(origin, vec_scale(of.x, right));
		Vec point = vec_add(from, vec_scale(0.5f * (of.y + radius - other), up));
		ends.separation[k] = flush_tiny(of.y - radius - other);
		ends.point[k] = vec_blend(point, vec_add(position, vec_turn(rotation, point)), e.swap);
		ends.feature[k] = blend_int(on_reference[k], on_incident[k], e.swap) * 256 |
		                  blend_int(on_incident[k], on_reference[k], e.swap);
	}
	ends.normal = vec_blend(up, vec_neg(vec_turn(rotation, up)), e.swap);
	return ends;
}

#endif
