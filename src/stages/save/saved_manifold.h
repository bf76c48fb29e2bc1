// SPDX-License-Identifier: MIT
// saved_manifold.h -- finds a short code from which the manifold of a contact follows, and computes the manifold from it.
//
// A manifold depends on the two shapes, on the pose of one in the frame of the other, and on the largest separation of
// its points. The save has the pose; the code has the edges and the points that collide has chosen. So the manifold is
// computed as in the step, but without the search for the edges, which takes most of the time. Whoever makes a code
// checks that the manifold has the same bits.
#ifndef SAVED_MANIFOLD_H
#define SAVED_MANIFOLD_H
#include "stages/geometry/manifold.h"

// Bits of a code.
#define SAVED_WAY       3u // mask of SAVED_NO_POINTS and so on
#define SAVED_NO_POINTS 0u // no points
#define SAVED_EDGES     1u // the clipped edge `incident` of one shape on edge `reference` of the other
#define SAVED_COLLIDE   2u // result of collide without a largest separation
#define SAVED_SWAP      4u // the reference edge is that of shape b
#define SAVED_HIGH      8u // the first end of the clipped edge is a point
#define SAVED_LOW       16u
#define SAVED_REFERENCE 5 // position of the number of the reference edge, 3 bits
#define SAVED_INCIDENT  8 // position of that of the incident edge, 3 bits
#define SAVED_CODE_BITS 11

#define SAVED_ANY_GAP 1.0e30f // m: larger than any separation

INLINE Manifold saved_manifold(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Frame f, Word code)
{
	if ((code & SAVED_WAY) == SAVED_NO_POINTS)
		return no_manifold();
	if ((code & SAVED_WAY) == SAVED_COLLIDE)
		return collide(a, b, f, reach_of(SAVED_ANY_GAP));
	const GLOBAL Attribute *reference = a, *incident = b;
	Frame frame = f;
	if (code & SAVED_SWAP)
	{
		reference = b;
		incident = a;
		frame = frame_inverse(f);
	}
	int j = (int)(code >> SAVED_INCIDENT & 7u);
	Reference r = reference_of(reference, (int)(code >> SAVED_REFERENCE & 7u));
	Edge edge = edge_of_shape(incident, j, &r, frame);
	Clip c = clip_edge(&edge, &r);
	Real facing = vec_dot(vec_turn_back(frame.rotation, r.up), shape_normal(incident, j));
	Manifold m = clip_manifold(reference, incident, &r, &edge, &c, facing, code & SAVED_HIGH ? SAVED_ANY_GAP : -SAVED_ANY_GAP,
	                           code & SAVED_LOW ? SAVED_ANY_GAP : -SAVED_ANY_GAP);
	return code & SAVED_SWAP ? manifold_swap(m, f) : m;
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
// that of the manifold, which tells the reference edge of shape a.
INLINE Word saved_code(const GLOBAL Attribute* a, const GLOBAL Attribute* b, int count, Int2 features, Vec normal, int k)
{
	int codes = count == 2 ? 2 : 4;
	if (count == 0 || k > codes)
		return SAVED_NO_POINTS;
	if (k == codes)
		return SAVED_COLLIDE;
	int last = count == 2 ? features.y : features.x, low = count == 1 && k & 1;
	Word here = (Word)(last >> 8) & 7u;
	int swap = !saved_normal_of(a, here, normal) && (count == 2 || !saved_normal_of(a, saved_edge_to(a, last >> 8), normal));
	swap ^= count == 2 ? k : k >> 1;
	const GLOBAL Attribute *reference = swap ? b : a, *incident = swap ? a : b;
	int on_reference = swap ? last & 255 : last >> 8, on_incident = swap ? features.x >> 8 : features.x & 255;
	Word i = count == 2 || low ? (Word)on_reference & 7u : saved_edge_to(reference, on_reference);
	Word j = low ? saved_edge_to(incident, on_incident) : (Word)on_incident & 7u;
	Word ends = count == 2 ? SAVED_HIGH | SAVED_LOW : low ? SAVED_LOW : SAVED_HIGH;
	return SAVED_EDGES | (swap ? SAVED_SWAP : 0u) | ends | i << SAVED_REFERENCE | j << SAVED_INCIDENT;
}

#endif
