// SPDX-License-Identifier: MIT
// saved_manifold.h -- finds a short code from which the manifold of a contact follows, and computes the manifold from it.
//
// A manifold depends on the two shapes, on the pose of one in the frame of the other, and on the largest separation of
// its points. The save has the pose; the code has the edges and the points that collide has chosen. So the manifold is
// computed as in the step, but without the search for the edges, which takes most of the time. A save checks that the
// manifold of a code has the same bits.
#ifndef SAVED_MANIFOLD_H
#define SAVED_MANIFOLD_H
#include "stages/geometry/manifold.h"
#include "stages/save/saved_codes.h"
#include "stages/save/saved_edges.h"

#define SAVED_ANY_GAP 1.0e30f // m: larger than any separation

// Returns the manifold of a code. a, b: attributes of the shapes; f: pose of shape b in the frame of shape a.
OUT_OF_LINE Manifold saved_manifold(const Pools* p, int a, int b, Frame f, Word code)
{
	if ((code & SAVED_WAY) == SAVED_NO_POINTS)
		return no_manifold();
	if ((code & SAVED_WAY) == SAVED_COLLIDE)
		return collide(p->attribute + a, p->attribute + b, f, reach_of(SAVED_ANY_GAP));
	SavedEdges e;
	saved_shapes(p, &e, a, b);
	e.swap = (code & SAVED_SWAP) != 0;
	e.edge = (int)(code >> SAVED_REFERENCE & 7u);
	e.other = (int)(code >> SAVED_INCIDENT & 7u);
	SavedEnds ends = saved_ends(p, e, f.position, f.rotation);
	Manifold m = no_manifold();
	int last = code & SAVED_HIGH ? 0 : 1;
	m.count = code & SAVED_HIGH && code & SAVED_LOW ? 2 : 1;
	m.normal = ends.normal;
	m.point[0] = last ? ends.point[1] : ends.point[0];
	m.separation[0] = last ? ends.separation[1] : ends.separation[0];
	m.feature[0] = last ? ends.feature[1] : ends.feature[0];
	if (m.count == 2)
	{
		m.point[1] = ends.point[1];
		m.separation[1] = ends.separation[1];
		m.feature[1] = ends.feature[1];
	}
	return m;
}

// Returns the edge that ends at a corner, or the edge itself. feature: index of a corner, or FEATURE_EDGE plus an edge.
INLINE Word saved_edge_to(const GLOBAL Attribute* shape, int feature)
{
	if (feature >= FEATURE_EDGE)
		return (Word)(feature - FEATURE_EDGE) & 7u;
	return (Word)(feature > 0 ? feature - 1 : shape->count - 1) & 7u;
}

// Returns whether the normal of a manifold is that of edge i of a shape.
INLINE int saved_normal_of(const GLOBAL Attribute* shape, Word i, Vec normal)
{
	Vec edge = shape_normal(shape, (int)i);
	return float_word(edge.x) == float_word(normal.x) && float_word(edge.y) == float_word(normal.y);
}

// Returns code number k, from 0, that may give a manifold with these features; SAVED_NO_POINTS after the last one. normal:
// that of the manifold, which is the normal of the reference edge if that is in shape a.
INLINE Word saved_code(const GLOBAL Attribute* a, const GLOBAL Attribute* b, int count, Int2 features, Vec normal,
                       int k)
{
	int codes = count == 2 ? 2 : 4;
	if (count == 0 || k > codes)
		return SAVED_NO_POINTS;
	if (k == codes)
		return SAVED_COLLIDE;
	int last = count == 2 ? features.y : features.x, low = count == 1 && k & 1;
	Word here = (Word)(last >> 8) & 7u;
	int swap =
	    !saved_normal_of(a, here, normal) && (count == 2 || !saved_normal_of(a, saved_edge_to(a, last >> 8), normal));
	swap ^= count == 2 ? k : k >> 1;
	const GLOBAL Attribute *reference = swap ? b : a, *incident = swap ? a : b;
	int on_reference = swap ? last & 255 : last >> 8, on_incident = swap ? features.x >> 8 : features.x & 255;
	Word i = count == 2 || low ? (Word)on_reference & 7u : saved_edge_to(reference, on_reference);
	Word j = low ? saved_edge_to(incident, on_incident) : (Word)on_incident & 7u;
	Word ends = count == 2 ? SAVED_HIGH | SAVED_LOW : low ? SAVED_LOW : SAVED_HIGH;
	return SAVED_EDGES | (swap ? SAVED_SWAP : 0u) | ends | i << SAVED_REFERENCE | j << SAVED_INCIDENT;
}

#endif
