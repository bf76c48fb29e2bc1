// SPDX-License-Identifier: MIT
// manifold_axis.h -- separating axis test: finds the edge along whose normal two convex cores are farthest apart.
//
// S. Gottschalk, Separating Axis Theorem, 1996: cores overlap if they overlap along the normals of all edges of both.
#ifndef MANIFOLD_AXIS_H
#define MANIFOLD_AXIS_H
#include "dialect/vec.h"
#include "pools/pools.h"

#define NO_AXIS (-1.0e30f) // lower than any separation

typedef struct // pose of one shape in the frame of another
{
	Vec position, rotation;
} Frame;

INLINE Frame frame_at(Vec position, Vec rotation)
{
	Frame f;
	f.position = position;
	f.rotation = rotation;
	return f;
}

typedef struct
{
	Real separation; // separation of the cores along the edge's normal, m
	int edge;        // edge of one core
	int corner;      // deepest corner of the other core
} Axis;

INLINE Vec shape_corner(const GLOBAL Attribute* shape, int i)
{
	Float2 v = shape->vertices[i];
	return vec(v.x, v.y);
}

INLINE Vec shape_normal(const GLOBAL Attribute* shape, int i)
{
	Float2 v = shape->normals[i];
	return vec(v.x, v.y);
}

INLINE int shape_next(const GLOBAL Attribute* shape, int i) { return i + 1 < shape->count ? i + 1 : 0; }

INLINE Vec frame_point(Frame f, Vec v) { return vec_add(f.position, vec_turn(f.rotation, v)); }

INLINE Frame frame_inverse(Frame f)
{
	Frame back;
	back.position = vec_neg(vec_turn_back(f.rotation, f.position));
	back.rotation = vec(f.rotation.x, -f.rotation.y);
	return back;
}

// Returns the edge of shape a along whose normal the separation of shape b is largest. The normals are rotated into the
// frame of shape b, so no rotated vertices are stored. The separation is NO_AXIS if shape a has only one corner.
INLINE Axis best_axis(const GLOBAL Attribute* a, const GLOBAL Attribute* b, Frame f)
{
	Axis best = {NO_AXIS, 0, 0};
	if (a->count == 1)
		return best;
	for (int i = 0; i < a->count; ++i)
	{
		Vec normal = shape_normal(a, i);
		Vec turned = vec_turn_back(f.rotation, normal);
		int corner = 0;
		Real lowest = vec_dot(turned, shape_corner(b, 0));
		for (int j = 1; j < b->count; ++j)
		{
			Real height = vec_dot(turned, shape_corner(b, j));
			if (height < lowest)
			{
				lowest = height;
				corner = j;
			}
		}
		Real separation = vec_dot(normal, vec_sub(f.position, shape_corner(a, i))) + lowest;
		if (separation > best.separation)
		{
			best.separation = separation;
			best.edge = i;
			best.corner = corner;
		}
	}
	return best;
}

#endif
