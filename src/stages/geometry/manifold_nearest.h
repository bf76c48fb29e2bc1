// SPDX-License-Identifier: MIT
// manifold_nearest.h -- finds the nearest points of two edges, and their features.
#ifndef MANIFOLD_NEAREST_H
#define MANIFOLD_NEAREST_H
#include "dialect/finite.h"

typedef struct // edge of a core; start and end as coordinates along the reference edge and along its normal, m
{
	Vec start, end;
	int start_feature, end_feature, feature;
} Edge;

typedef struct // nearest points of two edges: `from` is on the first edge, `to` on the second
{
	Vec from, to;
	Real square; // square of the distance of the two points, m^2
	int from_feature, to_feature;
} Nearest;

// Returns a corner as `to`, and as `from` the point of edge a that is nearest to it.
INLINE Nearest nearest_to_corner(Edge a, Vec corner, int feature)
{
	Vec direction = vec_sub(a.end, a.start);
	Real along = vec_dot(vec_sub(corner, a.start), direction), square = vec_dot(direction, direction);
	Nearest n;
	n.from = a.start;
	n.from_feature = a.start_feature;
	if (along >= ABSORBS && along < square)
	{
		n.from = vec_add(a.start, vec_scale(quotient(along, square), direction));
		n.from_feature = a.feature;
	}
	else if (along >= ABSORBS)
	{
		n.from = a.end;
		n.from_feature = a.end_feature;
	}
	n.to = corner;
	n.to_feature = feature;
	Vec delta = vec_sub(n.to, n.from);
	n.square = flush_below(vec_dot(delta, delta), ABSORBS);
	return n;
}

// Returns the nearest pair of a point of edge a and a corner of edge b.
INLINE Nearest nearest_corner(Edge a, Edge b)
{
	Nearest start = nearest_to_corner(a, b.start, b.start_feature);
	Nearest end = nearest_to_corner(a, b.end, b.end_feature);
	if (end.square < start.square)
		return end;
	return start;
}

// Returns the nearest points of two edges that do not cross, so that one of the points is a corner.
INLINE Nearest nearest_points(Edge a, Edge b)
{
	Nearest n = nearest_corner(a, b), back = nearest_corner(b, a);
	if (back.square < n.square)
	{
		n.from = back.to;
		n.to = back.from;
		n.square = back.square;
		n.from_feature = back.to_feature;
		n.to_feature = back.from_feature;
	}
	return n;
}

#endif
