// SPDX-License-Identifier: MIT
// hilbert.h -- computes the positions of the leaves of a tree along a Hilbert curve, by which the leaves are sorted.
#ifndef HILBERT_H
#define HILBERT_H
#include "stages/geometry/box.h"

#define TREE_CELLS 65535.0f // index of the last cell along a side

// Spreads the 16 bits of x to every second bit.
INLINE Int hilbert_spread(Int x)
{
	x = (x | x << 8) & 0x00ff00ff;
	x = (x | x << 4) & 0x0f0f0f0f;
	x = (x | x << 2) & 0x33333333;
	return (x | x << 1) & 0x55555555;
}

// Returns the distance of cell x, y along the Hilbert curve through 65,536 x 65,536 cells: two bits per level, from the
// largest quadrant down. The curve of a quadrant is rotated relative to that of its parent, so the orientation of a
// level is the product of all rotations above it. `a`, `b`, `c`, `d` are that product over 1, 2, 4, 8 and 16 levels,
// one bit per level, so four doublings replace a loop over 16 levels. rawrunprotected, 2D Hilbert Curves in O(1), 2011.
INLINE Int hilbert_distance(Int x, Int y)
{
	const int all = 65535;
	Int a = x ^ y, b = all ^ a, c = all ^ (x | y), d = x & (y ^ all);
	Int next_a = a | b >> 1, next_b = a >> 1 ^ a;
	Int next_c = (c >> 1 ^ (b & d >> 1)) ^ c, next_d = ((a & c >> 1) ^ d >> 1) ^ d;
	for (int levels = 2; levels <= 8; levels *= 2)
	{
		a = next_a;
		b = next_b;
		c = next_c;
		d = next_d;
		next_a = (a & a >> levels) ^ (b & b >> levels);
		next_b = (a & b >> levels) ^ (b & (a ^ b) >> levels);
		next_c ^= (a & c >> levels) ^ (b & d >> levels);
		next_d ^= (b & c >> levels) ^ ((a ^ b) & d >> levels);
	}
	a = next_c ^ next_c >> 1;
	b = next_d ^ next_d >> 1;
	Int low = x ^ y, high = b | (all ^ (low | a));
	return shifted(hilbert_spread(high & all), 1) | hilbert_spread(low);
}

// Returns the cell of the midpoint between two bounds, 0 if it is NaN, as in a world from a hostile snapshot. cells: number of
// cells per metre, counted from `begin`.
INLINE Int tree_cell(Real lower, Real upper, float begin, float cells)
{
	Real at = (0.5f * (lower + upper) - begin) * cells;
	return whole(minimum(splat(TREE_CELLS), maximum(splat(0.0f), at)));
}

// Writes the key of each leaf: the position of its box's center on the curve, then the collidable. argument: the tree,
// plus 2 for boxes of queries. Dead leaves get the largest keys, so the host can drop them.
WIDE_KERNEL(tree_code)
{
	const GLOBAL Tree* tree = p->tree + (p->argument & 1);
	GLOBAL Float4* boxes = p->argument & TREE_QUERIES ? p->query_box : p->node_box;
	Float4 bounds = box_unpack(boxes, tree->begin[tree->top] + ARITY);
	float width = bounds.z - bounds.x, height = bounds.w - bounds.y, side = width > height ? width : height;
	float cells = side > 0.0f ? quotient(TREE_CELLS, side) : 0.0f;
	Int leaf = indices(tree->begin[0] + i), place = shifted(leaf >> 3, 5) + (leaf & 7);
	Real box[4];
	for (int which = 0; which < 4; ++which)
		box[which] = gather((const GLOBAL float*)boxes, place + 8 * which);
	Int code = hilbert_distance(tree_cell(box[0], box[2], bounds.x, cells), tree_cell(box[1], box[3], bounds.y, cells));
	// clears a bit if all bits are set: only the key of a dead leaf may begin with such a code
	code = blend_int(code, code & ~1, code == -1);
	store_keys(p->key, i, blend_int(code, code | -1, box[0] > box[2]), load_int(p->leaf + tree->leaf_begin, i));
}

#endif
