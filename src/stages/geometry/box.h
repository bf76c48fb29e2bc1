// SPDX-License-Identifier: MIT
// box.h -- computes with axis-aligned boxes, which are stored as lower x, lower y, upper x, upper y in a Float4.
#ifndef BOX_H
#define BOX_H
#include "pools/pools.h"

INLINE Float4 box_empty(void) { return make_float4(EMPTY_LOW, EMPTY_LOW, EMPTY_HIGH, EMPTY_HIGH); }
INLINE int box_is_empty(Float4 b) { return b.x > b.z; }

INLINE int box_overlap(Float4 a, Float4 b) { return a.x <= b.z && b.x <= a.z && a.y <= b.w && b.y <= a.w; }

// Returns whether a contact must end: the boxes of its pair do not overlap now, or did not overlap in the last step.
// The latter occurs if a collidable was created in the slot of a destroyed one.
INLINE int box_parted(const Pools* p, Int2 pair)
{
	return !(box_overlap(p->box[pair.x], p->box[pair.y]) && box_overlap(p->old_box[pair.x], p->old_box[pair.y]));
}

INLINE int box_contains(Float4 outer, Float4 inner)
{
	return outer.x <= inner.x && outer.y <= inner.y && inner.z <= outer.z && inner.w <= outer.w;
}

INLINE int box_equal(Float4 a, Float4 b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; }

INLINE Float4 box_grow(Float4 b, float by) { return make_float4(b.x - by, b.y - by, b.z + by, b.w + by); }

INLINE Float4 box_union(Float4 a, Float4 b)
{
	return make_float4(b.x < a.x ? b.x : a.x, b.y < a.y ? b.y : a.y, b.z > a.z ? b.z : a.z, b.w > a.w ? b.w : a.w);
}

// Returns the index of one bound of box i in an array of boxes packed by eight (dialect.h). `which`: 0 lower x, 1 lower
// y, 2 upper x, 3 upper y.
INLINE int box_bound(int i, int which) { return (i & ~7) * 4 + 8 * which + (i & 7); }

INLINE Float4 box_unpack(const GLOBAL Float4* boxes, int i)
{
	const GLOBAL float* bounds = (const GLOBAL float*)boxes;
	return make_float4(bounds[box_bound(i, 0)], bounds[box_bound(i, 1)], bounds[box_bound(i, 2)],
	                   bounds[box_bound(i, 3)]);
}

INLINE void box_pack(GLOBAL Float4* boxes, int i, Float4 box)
{
	GLOBAL float* bounds = (GLOBAL float*)boxes;
	bounds[box_bound(i, 0)] = box.x;
	bounds[box_bound(i, 1)] = box.y;
	bounds[box_bound(i, 2)] = box.z;
	bounds[box_bound(i, 3)] = box.w;
}

// Returns the box around eight packed boxes.
INLINE Float4 box_around(const GLOBAL Float4* boxes)
{
	Bound8 lower_x = bound8(boxes, 0), lower_y = bound8(boxes, 1), upper_x = bound8(boxes, 2),
	       upper_y = bound8(boxes, 3);
	Float4 box = make_float4(bound_at(lower_x, 0), bound_at(lower_y, 0), bound_at(upper_x, 0), bound_at(upper_y, 0));
	UNROLL
	for (int k = 1; k < 8; ++k)
		box = box_union(
		    box, make_float4(bound_at(lower_x, k), bound_at(lower_y, k), bound_at(upper_x, k), bound_at(upper_y, k)));
	return box;
}

#endif
