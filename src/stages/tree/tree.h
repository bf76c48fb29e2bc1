// SPDX-License-Identifier: MIT
// tree.h -- builds and traverses trees of boxes: leaves in the order of a Hilbert curve, ARITY children per node.
//
// This work is based on:
// Ibrahim Kamel, Christos Faloutsos, On Packing R-trees, 1993.
//
// The children of node n of a level are ARITY nodes of the level below, from ARITY * n on, so no pointers are needed. A
// level is built by one pass over the level below, the eight boxes of a node are one cache line of a GPU, and a
// traversal needs a stack of 8 bits per level. The order of leaves affects only speed. A binary radix tree (Karras,
// Maximizing Parallelism in the Construction of BVHs, 2012) has tighter nodes, but needs pointers, atomics between
// compute units to refit, and 20 levels instead of 7.
#ifndef TREE_H
#define TREE_H
#include "pools/bays.h"
#include "stages/geometry/box.h"
#include "stages/geometry/filter.h"
#include "stages/tree/hilbert.h"

// A node is an outlier if its area is more than OUTLIER_BOXES times the mean area of its leaves. A node around eight
// equal boxes, corner to corner along a diagonal, has this ratio.
#define OUTLIER_BOXES 64.0f

INLINE int tree_of_kind(int kind) { return (kind & ~KIND_SENSOR) == KIND_STATIC; }

// Returns whether a collidable of a kind is alive and in tree t; otherwise a leaf of it is empty. A batch has only tree 0.
INLINE int tree_contains(const Pools* p, int t, int kind)
{
	return kind != KIND_DEAD && (BATCHED(p) || tree_of_kind(kind) == t);
}

// Returns whether there are static collidables, perhaps in other worlds of a batch.
INLINE int tree_statics(const Pools* p) { return BATCHED(p) || p->tree[1].leaves > 0; }

#define LEAF_SOON 16 // prefetch distance, in leaves

// Item: a leaf. argument: the tree. A leaf whose collidable is dead or has moved to the other tree gets an empty box.
KERNEL(tree_leaf)
{
	const GLOBAL Tree* tree = p->tree + p->argument;
	Float4 box = box_empty();
	if (FETCHES && i + LEAF_SOON < tree->leaves)
	{
		int soon = p->leaf[tree->leaf_begin + i + LEAF_SOON];
		fetch_soon(p->box + soon);
		fetch_soon(p->collidable_kind + soon);
	}
	if (i < tree->leaves)
	{
		int k = p->leaf[tree->leaf_begin + i], kind = p->collidable_kind[k];
		if (tree_contains(p, p->argument, kind))
			box = p->box[k];
		if (p->step.sleep && p->argument == 0)
			p->leaf_place[k] = i;
	}
	box_pack(p->node_box, tree->begin[0] + i, box);
}

// Lists the node of a level that contains node i of the level below, in tree 0, unless it is listed already.
INLINE void tree_mark_above(const Pools* p, const GLOBAL Tree* tree, int level, int i)
{
	int first = tree->begin[level - 1] / ARITY, node = i / ARITY;
	GLOBAL int* stale = p->node_stale + first + node;
	if (level > tree->top || read_shared(stale) || atomic_max_int(stale, 1))
		return;
	p->stale_nodes[first + atomic_add_int(&p->counters->stale_nodes[level], 1)] = node;
}

INLINE void tree_join(GLOBAL Float4* boxes, const GLOBAL Tree* tree, int level, int i)
{
	Float4 box = i < tree->count[level] ? box_around(boxes + tree->begin[level - 1] + ARITY * i) : box_empty();
	box_pack(boxes, tree->begin[level] + i, box);
}

// Returns a mask for node i: bit k is set if a leaf below child k can touch a kinematic collidable. Traversals for
// kinematic collidables skip other children; otherwise each of 40,000 shapes of one body would visit its neighbors.
INLINE Word tree_movers(const Pools* p, const GLOBAL Tree* tree, int level, int i)
{
	Word movers = 0;
	for (int k = ARITY * i; k < ARITY * (i + 1) && k < tree->count[level - 1]; ++k)
	{
		int moves = level == 1 ? kinds_meet(KIND_KINEMATIC, p->collidable_kind[p->leaf[tree->leaf_begin + k]])
		                       : p->node_movers[tree->begin[level - 2] / ARITY + k] != 0;
		movers |= (Word)moves << (k - ARITY * i);
	}
	return movers;
}

// Returns the listed node number i of a level of tree 0, takes it from the list, and lists its parent.
INLINE int tree_stale_node(const Pools* p, int level, int i)
{
	int first = p->tree->begin[level - 1] / ARITY, node = p->stale_nodes[first + i];
	p->node_stale[first + node] = 0;
	tree_mark_above(p, p->tree, level + 1, node);
	return node;
}

// Item: a node of a level, or with TREE_STALE_ONLY a listed node, whose parent is then listed. Computes its box and its
// mask (tree_movers). argument: the tree, TREE_STALE_ONLY, the level.
KERNEL(tree_node)
{
	int t = RUN_LOW(p->argument) & 1, level = RUN_HIGH(p->argument);
	const GLOBAL Tree* tree = p->tree + t;
	if (RUN_LOW(p->argument) & TREE_STALE_ONLY)
		i = tree_stale_node(p, level, i);
	tree_join(p->node_box, tree, level, i);
	if (p->step.kinematic > 0 && i < tree->count[level])
		p->node_movers[tree->begin[level - 1] / ARITY + i] = tree_movers(p, tree, level, i);
}

// Returns tree_movers for the node whose children are the eight nodes of a level from `first` on; 255 at the top level.
INLINE Word tree_movers_of(const Pools* p, const GLOBAL Tree* tree, int level, int first)
{
	return level < tree->top ? p->node_movers[(tree->begin[level] + first) / ARITY] : 255u;
}

INLINE float box_area(Float4 b) { return (b.z - b.x) * (b.w - b.y); }

// Item: a node of level 1, or with TREE_STALE_ONLY a listed node. argument: the tree, TREE_STALE_ONLY. Adds to the
// estimate of wasted visits: a leaf that is new or jumped makes the nodes above it outliers, which traversals visit in
// vain. The expected fraction of traversals that visit such a node is its area divided by the sum of the areas of all
// leaves. Nodes below the limit OUTLIER_BOXES do not count.
KERNEL(tree_outlier)
{
	int t = p->argument & 1;
	const GLOBAL Tree* tree = p->tree + t;
	Float4 now = box_empty(), before = box_empty();
	float area = 0.0f;
	int leaves = 0, jumped = 0;
	if (p->argument & TREE_STALE_ONLY)
		i = p->stale_nodes[tree->begin[0] / ARITY + i];
	for (int k = ARITY * (i + 1); FETCHES && k < ARITY * (i + 2) && k < tree->leaves; ++k)
	{
		int leaf = p->leaf[tree->leaf_begin + k];
		fetch_soon(p->box + leaf);
		fetch_soon(p->old_box + leaf);
	}
	for (int k = ARITY * i; k < ARITY * (i + 1) && k < tree->leaves; ++k)
	{
		int leaf = p->leaf[tree->leaf_begin + k], kind = p->collidable_kind[leaf];
		if (!tree_contains(p, t, kind))
			continue;
		Float4 box = p->box[leaf], old = p->old_box[leaf];
		jumped |= (p->collidable_flags[leaf] & COLLIDABLE_NEW_BOX) && !box_overlap(box, old);
		now = box_union(now, box);
		before = box_union(before, old);
		area += box_area(box);
		++leaves;
	}
	if (!jumped)
		return;
	float mean = quotient(area, (float)leaves), wide = box_area(now);
	if (!(wide > OUTLIER_BOXES * mean))
		return;
	// subtracts the old area; factor 2 below: after a jump, the upper nodes cost about as much as this one
	wide -= box_is_empty(before) ? 0.0f : box_area(before);
	float traversals = quotient(2.0f * wide, mean * (float)tree->leaves);
	if (traversals < 0.0f) // a large negative number would be outside the range of int
		return;
	int outliers = traversals < 2.0f ? (int)((float)OUTLIER_UNIT * traversals) : 2 * OUTLIER_UNIT;
	if (outliers > 0)
		atomic_add_int(&p->counters->outliers[t], outliers);
}

// Requests a sort of the leaves if the wasted visits of this step cost more than the sort. Smaller costs are summed
// over steps (src/step/tree_maintenance.c).
KERNEL(tree_measure_quality)
{
	GLOBAL Counters* c = p->counters;
	int t = p->argument;
	Word64 visits = (Word64)c->updated_boxes * (Word64)c->outliers[t];
	if (visits > (Word64)(ORDER_VISITS * OUTLIER_UNIT) * (Word64)p->tree[t].leaves)
		c->order[t] = 0x7fffffff;
	(void)i;
}

// Computes the box around all leaves and stores it behind the nodes of the highest level. argument: as in tree_code.
KERNEL(tree_root)
{
	const GLOBAL Tree* tree = p->tree + (p->argument & 1);
	GLOBAL Float4* boxes = p->argument & TREE_QUERIES ? p->query_box : p->node_box;
	int top = tree->begin[tree->top];
	box_pack(boxes, top + ARITY, box_around(boxes + top));
	(void)i;
}

KERNEL(tree_order)
{
	p->leaf[p->tree[p->argument].leaf_begin + i] = (int)(p->key[i] & (Word64)0xffffffffu);
	if (i == 0)
		p->counters->outliers[p->argument] = 0;
}

// Returns a mask of the eight nodes from `first` on: bit k is set if node first + k overlaps the box.
INLINE Word64 tree_hits(const Pools* p, int first, Float4 box) { return (Word64)overlaps8(p->node_box + first, box); }

// Returns a mask of eight nodes of a level: bit k is set if node first + k has a leaf with `from` <= index < `end`.
INLINE Word64 tree_span(int level, int first, int from, int end)
{
	int low = (from >> (ARITY_BITS * level)) - first, high = ((end - 1) >> (ARITY_BITS * level)) - first;
	if (low >= ARITY || high < 0)
		return 0;
	Word64 span = low > 0 ? (Word64)255 << low : (Word64)255;
	return high < ARITY - 1 ? span & (((Word64)2 << high) - (Word64)1) : span;
}

typedef struct // traversal of the nodes of level 1 that overlap a box, by rising leaf index
{
	Word64 masks;     // 8 bits per level: siblings on the current path that are still to be visited
	Word64 leaves;    // mask of the leaves of the current node that overlap the box
	int level, first; // current position: level, and first of eight siblings
	int from, end;    // range of leaves, end excluded; end 0: all leaves
	int nodes;        // number of nodes of level 1 that may still be visited
	int movers;       // 1: visit only nodes below which a leaf can touch a kinematic collidable
} TreeTraversal;

// Returns the lowest level at which eight siblings cover all leaves with `from` <= index < `end`.
INLINE int tree_level_of(const GLOBAL Tree* tree, int from, int end)
{
	int level = 0;
	for (Word apart = (Word)(from ^ (end - 1)) >> ARITY_BITS; apart != 0 && level < tree->top; apart >>= ARITY_BITS)
		++level;
	return level;
}

// Starts a traversal of a tree that is not empty, over leaves with `from` <= index < `end`, or over all if `end` is 0.
INLINE TreeTraversal tree_traverse(const Pools* p, const GLOBAL Tree* tree, Float4 box, int from, int end, int nodes)
{
	TreeTraversal traversal;
	traversal.level = BATCHED(p) ? tree_level_of(tree, from, end) : tree->top;
	traversal.first = BATCHED(p) ? from >> (ARITY_BITS * traversal.level) & ~(ARITY - 1) : 0;
	traversal.from = from;
	traversal.end = end;
	traversal.nodes = nodes;
	traversal.movers = 0;
	traversal.leaves = 0;
	traversal.masks = tree_hits(p, tree->begin[traversal.level] + traversal.first, box);
	if (end)
		traversal.masks &= tree_span(traversal.level, traversal.first, from, end);
	traversal.masks = traversal.masks << (8 * traversal.level);
	return traversal;
}

// Advances to the next node of level 1 and returns the index of its first leaf. Sets traversal->leaves to a mask of its
// leaves that overlap the box. Returns TREE_DONE after the last node, TREE_LEFT if the limit of visited nodes is
// reached; the caller must then continue at traversal->first.
#define TREE_DONE (-1)
#define TREE_LEFT (-2)
INLINE int tree_next(const Pools* p, const GLOBAL Tree* tree, Float4 box, TreeTraversal* traversal)
{
	for (;;)
	{
		// lowest level with remaining nodes, found in one operation
		Word64 left = traversal->masks >> (8 * traversal->level);
		if (left == 0)
			return TREE_DONE;
		int lowest = lowest_bit(left), up = lowest / 8, child = lowest % 8;
		traversal->level += up;
		traversal->first = traversal->first >> (ARITY_BITS * up) & ~(ARITY - 1);
		if (traversal->level == 0)
		{
			traversal->leaves = traversal->masks & (Word64)255;
			traversal->masks ^= traversal->leaves;
			return traversal->first;
		}
		traversal->masks ^= (Word64)1 << (8 * traversal->level + child);
		traversal->first = ARITY * (traversal->first + child);
		if (--traversal->level == 0 && --traversal->nodes < 0)
			return TREE_LEFT;
		Word64 hits = tree_hits(p, tree->begin[traversal->level] + traversal->first, box);
		if (traversal->end)
			hits &= tree_span(traversal->level, traversal->first, traversal->from, traversal->end);
		if (traversal->movers)
			hits &= (Word64)tree_movers_of(p, tree, traversal->level, traversal->first);
		traversal->masks |= hits << (8 * traversal->level);
	}
}

#endif
