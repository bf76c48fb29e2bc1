// SPDX-License-Identifier: MIT
// convex.h -- computes the exact distance of a point from a rounded convex core, and a moving point's first contact.
//
// A shape consists of all points within a radius of its core; the core is the convex hull of its corners. A core may
// also be the Minkowski sum of one shape and the mirror image of another (convex_sum.h), because the distance of two
// shapes is the distance of the second shape's origin from this sum. So the functions of this file answer all queries.
//
// This work is based on:
// Mike Cyrus, Jay Beck, Generalized Two- and Three-dimensional Clipping, 1978: a line against half-planes.
// Christer Ericson, Real-Time Collision Detection, 2005, 5.1 and 5.3: Voronoi regions, the line against a sphere.
#ifndef CONVEX_H
#define CONVEX_H
#include "dialect/finite.h"
#include "stages/geometry/manifold_axis.h"

typedef struct
{
	const GLOBAL Attribute* shape; // shape to which the core belongs; null for a sum
	const Vec* corners;            // corners of a sum, counter-clockwise
	const Vec* normals;            // outward normals of the edges of a sum; edge k leads from corner k to k + 1
	int count;                     // number of corners
	int thin;                      // 1 if the core has no area: it has two edges, back to back
	Real radius;                   // m: distance of the surface from the core
} Convex;

typedef struct // nearest point of a core
{
	int edge, corner; // edge of the nearest point; corner if that point is a corner, otherwise -1
	Real separation;  // m: distance of the query point from the surface (core plus radius); negative inside
	Vec normal;       // outward unit normal of the surface, toward the query point if it is outside
} ConvexNearest;

typedef struct // first contact of a moving point with the surface
{
	int hit, inside;  // `hit`: 1 if there is a contact; `inside`: 1 if the path begins inside the shape
	float fraction;   // fraction of the path before the contact
	int edge, corner; // as in ConvexNearest
	Vec normal;
} ConvexHit;

INLINE Convex convex_of(const GLOBAL Attribute* shape, Real radius)
{
	Convex c;
	c.shape = shape;
	c.corners = 0;
	c.normals = 0;
	c.count = shape->count;
	c.thin = shape->count < 3;
	c.radius = shape->radius + radius;
	return c;
}

INLINE Vec convex_corner(const Convex* c, int k) { return c->shape ? shape_corner(c->shape, k) : c->corners[k]; }
INLINE Vec convex_normal(const Convex* c, int k) { return c->shape ? shape_normal(c->shape, k) : c->normals[k]; }
INLINE int convex_next(const Convex* c, int k) { return k + 1 < c->count ? k + 1 : 0; }
INLINE int convex_before(const Convex* c, int k) { return k > 0 ? k - 1 : c->count - 1; }

// Returns the position of point q along edge k, m, relative to the corner with the index `from`.
INLINE Real convex_along(const Convex* c, int k, int from, Vec q)
{
	Vec up = convex_normal(c, k);
	return vec_cross(up, vec_sub(q, convex_corner(c, from)));
}

// Finds the Voronoi region that contains a point outside the core. Returns its edge. *corner: index of the corner if
// the region belongs to a corner, otherwise -1. `edge`: first edge to test; the point is on its outer side. Two nearly
// parallel edges may each assign the point to the other edge, so the search ends after as many edges as the core has.
INLINE int convex_region(const Convex* c, int edge, Vec q, int* corner)
{
	*corner = -1;
	for (int turn = 0; turn < c->count; ++turn)
	{
		int next = convex_next(c, edge), before = convex_before(c, edge);
		if (convex_along(c, edge, edge, q) < 0.0f)
		{
			if (!(convex_along(c, before, edge, q) < 0.0f))
			{
				*corner = edge;
				return edge;
			}
			edge = before;
		}
		else if (convex_along(c, edge, next, q) > 0.0f)
		{
			if (!(convex_along(c, next, next, q) > 0.0f))
			{
				*corner = next;
				return edge;
			}
			edge = next;
		}
		else
			break;
	}
	return edge;
}

// Returns the result for a point whose nearest point of the core is a corner. up: normal exactly at the corner.
INLINE ConvexNearest convex_at_corner(const Convex* c, int edge, int corner, Vec q, Vec up)
{
	Vec d = vec_sub(q, convex_corner(c, corner));
	Real distance = root(vec_dot(d, d));
	ConvexNearest n;
	n.edge = edge;
	n.corner = corner;
	n.separation = flush_tiny(distance - c->radius);
	n.normal = distance >= TINY ? vec(quotient(d.x, distance), quotient(d.y, distance)) : up;
	return n;
}

INLINE ConvexNearest convex_nearest(const Convex* c, Vec q)
{
	if (c->count == 1)
		return convex_at_corner(c, 0, 0, q, vec(0.0f, 1.0f));
	ConvexNearest n;
	n.edge = 0;
	Real highest = NO_AXIS;
	for (int k = 0; k < c->count; ++k)
	{
		Real height = vec_dot(convex_normal(c, k), vec_sub(q, convex_corner(c, k)));
		if (height > highest)
		{
			highest = height;
			n.edge = k;
		}
	}
	n.corner = -1;
	if (c->thin || !(highest < 0.0f))
		n.edge = convex_region(c, n.edge, q, &n.corner);
	n.normal = convex_normal(c, n.edge);
	if (n.corner >= 0)
		return convex_at_corner(c, n.edge, n.corner, q, n.normal);
	n.separation = flush_tiny(vec_dot(n.normal, vec_sub(q, convex_corner(c, n.edge))) - c->radius);
	return n;
}

INLINE ConvexHit convex_miss(void)
{
	ConvexHit hit;
	hit.hit = hit.inside = hit.edge = 0;
	hit.corner = -1;
	hit.fraction = 1.0f;
	hit.normal = vec(0.0f, 0.0f);
	return hit;
}

// Returns the first contact of a point, which begins outside, with the circle around a corner. The point of the line
// that is nearest to the corner is computed first: a discriminant would miss a small circle at the end of a long path.
INLINE ConvexHit convex_hit_corner(const Convex* c, int edge, int corner, Vec q, Vec path)
{
	ConvexHit hit = convex_miss();
	Vec from = vec_sub(q, convex_corner(c, corner));
	Real closing = -vec_dot(from, path), square = vec_dot(path, path);
	if (!(closing >= ABSORBS) || !(square >= ABSORBS))
		return hit;
	Real middle = quotient(closing, square);
	Vec passing = vec_add(from, vec_scale(middle, path));
	Real room = c->radius * c->radius - vec_dot(passing, passing);
	if (room < 0.0f)
		return hit;
	Real fraction = maximum(middle - root(quotient(room, square)), 0.0f);
	if (fraction > 1.0f)
		return hit;
	Vec at = vec_add(from, vec_scale(fraction, path));
	Real distance = root(vec_dot(at, at)), length = root(square);
	hit.hit = 1;
	hit.fraction = fraction;
	hit.edge = edge;
	hit.corner = corner;
	hit.normal = distance >= TINY ? vec(quotient(at.x, distance), quotient(at.y, distance))
	                              : vec(quotient(-path.x, length), quotient(-path.y, length));
	return hit;
}

INLINE ConvexHit convex_inside(int edge, int corner)
{
	ConvexHit hit = convex_miss();
	hit.hit = hit.inside = 1;
	hit.fraction = 0.0f;
	hit.edge = edge;
	hit.corner = corner;
	return hit;
}

// Returns the fraction of the path at which the moving point reaches edge k, whose corners are on different sides of
// the path's line. If edge and path are nearly parallel, rounding may give any fraction, so it is clamped to the range
// between the fractions of the two corners. For a path of squared length 0 this range is NaN and clamps nothing.
INLINE Real convex_share(const Convex* c, int k, Vec q, Vec path)
{
	Vec normal = convex_normal(c, k), from = vec_sub(convex_corner(c, k), q),
	    to = vec_sub(convex_corner(c, convex_next(c, k)), q);
	Real square = vec_dot(path, path), first = quotient(vec_dot(from, path), square),
	     last = quotient(vec_dot(to, path), square);
	Real share = maximum(quotient(vec_dot(normal, from), vec_dot(normal, path)), minimum(first, last));
	return minimum(share, maximum(first, last));
}

// Returns the first contact with a core of radius 0. The path's line enters and leaves through the edges whose corners
// are on different sides of it. Both edges of a corner use one test of its side, so no path can pass between them.
INLINE ConvexHit convex_hit_sharp(const Convex* c, Vec q, Vec path)
{
	ConvexHit hit = convex_miss();
	int enters = -1, leaves = -1, before = c->count - 1;
	int right = vec_cross(path, vec_sub(convex_corner(c, before), q)) < 0.0f;
	for (int k = 0; k < c->count; before = k, ++k)
	{
		int was = right;
		right = vec_cross(path, vec_sub(convex_corner(c, k), q)) < 0.0f;
		if (was < right)
			enters = before;
		if (was > right)
			leaves = before;
	}
	if (enters >= 0)
	{
		Real share = convex_share(c, enters, q, path);
		if (share > 1.0f || convex_share(c, leaves, q, path) < 0.0f)
			return hit;
		if (share > 0.0f)
		{
			hit.hit = 1;
			hit.fraction = share;
			hit.edge = enters;
			hit.normal = convex_normal(c, enters);
			return hit;
		}
	}
	ConvexNearest n = convex_nearest(c, q);
	return n.separation <= 0.0f ? convex_inside(n.edge, n.corner) : hit;
}

// Returns the first contact of a point that moves from q along a path. The half-planes of the edges, moved outward by
// the radius, enclose the shape, but do not round its corners; near a corner the circle around it is used instead.
INLINE ConvexHit convex_hit(const Convex* c, Vec q, Vec path)
{
	if (c->count > 1 && !(c->radius > 0.0f))
		return convex_hit_sharp(c, q, path);
	ConvexHit hit = convex_miss();
	Real lower = 0.0f, upper = 1.0f;
	int edge = -1;
	for (int k = 0; c->count > 1 && k < c->count; ++k)
	{
		Vec normal = convex_normal(c, k);
		Real room = flush_tiny(vec_dot(normal, vec_sub(convex_corner(c, k), q)) + c->radius),
		     speed = flush_tiny(vec_dot(normal, path));
		if (speed == 0.0f)
		{
			if (room < 0.0f)
				return hit;
		}
		else if (speed < 0.0f)
		{
			if (room < lower * speed)
			{
				lower = quotient(room, speed);
				edge = k;
			}
		}
		else if (room < upper * speed)
			upper = quotient(room, speed);
		if (upper < lower)
			return hit;
	}
	if (edge < 0)
	{
		ConvexNearest n = convex_nearest(c, q);
		if (n.separation <= 0.0f)
			return convex_inside(n.edge, n.corner);
		return n.corner < 0 ? hit : convex_hit_corner(c, n.edge, n.corner, q, path);
	}
	int corner = -1;
	edge = convex_region(c, edge, vec_add(q, vec_scale(lower, path)), &corner);
	if (corner >= 0)
		return convex_hit_corner(c, edge, corner, q, path);
	hit.hit = 1;
	hit.fraction = lower;
	hit.edge = edge;
	hit.normal = convex_normal(c, edge);
	return hit;
}

#endif
