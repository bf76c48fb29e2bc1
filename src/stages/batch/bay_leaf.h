// SPDX-License-Identifier: MIT
// bay_leaf.h -- computes the boxes of the leaves of a batch, of which leaf i is that of collidable i.
#ifndef BAY_LEAF_H
#define BAY_LEAF_H
#include "stages/geometry/box.h"

#if LANES == 1
INLINE void bay_leaf_store(const Pools* p, int leaf, Real x, Real y, Real z, Real w)
{
	box_pack(p->node_box, leaf, make_float4(x, y, z, w));
}
#else
#define LEAF_BLOCK (LANES < ARITY ? LANES : ARITY) // number of lanes whose bounds are adjacent

// Stores bounds of the boxes of LANES leaves; boxes are packed by eight.
INLINE void bay_leaf_bound(const Pools* p, int leaf, int which, Real bound)
{
	for (int k = 0; k < LANES; k += LEAF_BLOCK)
		memcpy((float*)p->node_box + box_bound(leaf + k, which), (const char*)&bound + sizeof(float) * (size_t)k,
		       sizeof(float) * LEAF_BLOCK);
}

INLINE void bay_leaf_store(const Pools* p, int leaf, Real x, Real y, Real z, Real w)
{
	bay_leaf_bound(p, leaf, 0, x);
	bay_leaf_bound(p, leaf, 1, y);
	bay_leaf_bound(p, leaf, 2, z);
	bay_leaf_bound(p, leaf, 3, w);
}
#endif

// Item: a leaf. One of a dead collidable, or behind the last one, gets an empty box. The kernel may write empty boxes
// behind the leaves, to nodes that are computed afterwards.
WIDE_KERNEL(bay_leaf)
{
	const GLOBAL Tree* tree = p->tree;
	Real b[4];
	load_rows4((GLOBAL float*)p->box, i, b);
	Int there = (load_int(p->collidable_kind, i) != KIND_DEAD) & (indices(i) < tree->leaves);
	Real low = splat(EMPTY_LOW), high = splat(EMPTY_HIGH);
	bay_leaf_store(p, tree->begin[0] + i, blend(low, b[0], there), blend(low, b[1], there), blend(high, b[2], there),
	               blend(high, b[3], there));
}

#endif
