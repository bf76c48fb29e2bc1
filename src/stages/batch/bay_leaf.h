// SPDX-License-Identifier: MIT
// bay_leaf.h -- computes the boxes of the leaves of a batch, of which leaf i is that of collidable i.
#ifndef BAY_LEAF_H
#define BAY_LEAF_H
#include "stages/geometry/box.h"

#define LEAF_BLOCK (LANES < ARITY ? LANES : ARITY) // number of lanes whose bounds are adjacent

// Stores bounds of the boxes of LANES leaves; boxes are packed by eight.
INLINE void bay_leaf_bound(const Pools* p, int leaf, int which, Real bound)
{
	for (int k = 0; k < LANES; k += LEAF_BLOCK)
		store_lanes((GLOBAL float*)p->node_box + box_bound(leaf + k, which), bound, k, LEAF_BLOCK);
}

// Item: a leaf. One of a dead collidable, or behind the last one, gets an empty box. The kernel may write empty boxes
// behind the leaves, to nodes that are computed afterwards.
WIDE_KERNEL(bay_leaf)
{
	const GLOBAL Tree* tree = p->tree;
	Real b[4];
	load_rows4((GLOBAL float*)p->box, i, b);
	Int there = (load_int(p->collidable_kind, i) != KIND_DEAD) & (indices(i) < tree->leaves);
	Real low = splat(EMPTY_LOW), high = splat(EMPTY_HIGH);
	for (int which = 0; which < 4; ++which)
		bay_leaf_bound(p, tree->begin[0] + i, which, blend(which < 2 ? low : high, b[which], there));
}

#endif
