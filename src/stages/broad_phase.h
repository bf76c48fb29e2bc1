// SPDX-License-Identifier: MIT
// broad_phase.h -- moved boxes against the trees: the set of new pairs.
//
// A contact exists exactly as long as the enlarged boxes of its collidables overlap. So a pair is new when its boxes
// overlap now and did not before this step's transform; no table of known pairs is needed. A pair of which both moved
// is taken by the one of the lower index.
//
// Leaves are met in rising order, so that a walk can be stopped at any leaf and gone on with elsewhere.
#ifndef BROAD_PHASE_H
#define BROAD_PHASE_H
#include "stages/filter.h"
#include "stages/tree.h"

// Pair i, j, when it is new. Returns whether the walk may go on: not when there are more pairs than a world may have.
INLINE int broad_phase_leaf(const Pools* p, int i, int j)
{
	// most neighbors are known ones
	if (box_overlap(p->old_box[i], p->old_box[j]) || i == j || ((p->moved[j] & MOVED_BOX) && j < i))
		return 1;
	int body = p->collidable_body[i];
	if (body >= 0 && body == p->collidable_body[j])
		return 1;
	if (!kinds_meet(p->collidable_kind[i], p->collidable_kind[j]) || !filter_accepts(p->filter[i], p->filter[j]))
		return 1;
	int place = atomic_add_int(&p->counters->pairs, 1);
	int a = i < j ? i : j, b = i < j ? j : i;
	if (place < p->step.pair_capacity)
		p->key[place] = (Word64)a << p->step.key_bits | (Word64)b;
	return place < p->step.contact_limit;
}

// Visits the leaves of tree t that overlap the box of collidable i, in rising order: those from leaf from up to, not
// including, end, or, with end 0, all. masks holds, 8 bits a level, which of the eight siblings on the current path are
// still to be visited. A walk visits so many nodes over leaves, at least one, and returns the leaf at which it has to go
// on, or 0 when it is done.
INLINE int broad_phase_walk(const Pools* p, int i, int t, int from, int end, int nodes)
{
	const GLOBAL Tree* tree = p->tree + t;
	// once there are too many pairs, the others need not be found
	if (tree->leaves == 0 || read_shared(&p->counters->pairs) > p->step.contact_limit)
		return 0;
	Float4 box = p->box[i];
	int level = tree->top, first = 0;
	Word64 masks = tree_hits(p, tree->begin[level], box);
	if (end)
		masks &= tree_span(level, 0, from, end);
	masks = masks << (8 * level);
	for (;;)
	{
		Word64 siblings = masks >> (8 * level) & (Word64)255;
		if (siblings == 0)
		{
			if (level == tree->top)
				return 0;
			++level;
			first = first / ARITY & ~(ARITY - 1);
			continue;
		}
		Word64 lowest = siblings & (~siblings + (Word64)1);
		int child = first + 63 - leading_zeros(lowest);
		masks ^= lowest << (8 * level);
		if (level == 0)
		{
			if (!broad_phase_leaf(p, i, p->leaf[tree->leaf_begin + child]))
				return 0;
		}
		else
		{
			first = ARITY * child;
			if (--level == 0 && --nodes < 0)
				return first;
			Word64 hits = tree_hits(p, tree->begin[level] + first, box);
			if (end)
				hits &= tree_span(level, first, from, end);
			masks |= hits << (8 * level);
		}
	}
}

// the search anew, after a buffer grew
STAGE(broad_phase_begin)
{
	p->counters->pairs = 0;
	p->counters->walks = 0;
	p->counters->rest = 0;
	p->counters->created = 0;
	p->counters->stalled = 0;
	(void)i;
}

// A box that overlaps thousands of leaves would keep one work-item busy when all others are done: what it leaves undone
// is listed.
STAGE(broad_phase)
{
	int k = p->moved_list[i], kind = p->collidable_kind[k], trees = kind == KIND_DYNAMIC || kind == KIND_FREE ? 2 : 1;
	for (int t = 0; t < trees; ++t)
	{
		int next = broad_phase_walk(p, k, t, 0, 0, p->step.walk_nodes);
		if (next == 0)
			continue;
		p->walk[atomic_add_int(&p->counters->walks, 1)] = make_int2(2 * k + t, next);
		raise_int(&p->counters->rest, 0x7fffffff);
	}
}

// The rests of the long walks, each cut by its leaves into as many parts as there are work-items for it. Where there are
// more walks than work-items, an item takes several.
STAGE(broad_phase_rest)
{
	int walks = p->counters->walks, parts = walks < p->step.walkers ? p->step.walkers / walks : 1;
	int teams = p->step.walkers / parts;
	for (int w = i / parts; w < walks && i < teams * parts; w += teams)
	{
		Int2 walk = p->walk[w];
		int k = walk.x / 2, t = walk.x % 2, leaves = p->tree[t].leaves;
		int begin = walk.y / ARITY, blocks = (leaves - 1) / ARITY + 1 - begin, share = (blocks - 1) / parts + 1;
		int from = ARITY * (begin + share * (i % parts)), end = from + ARITY * share;
		from = from < walk.y ? walk.y : from;
		end = end < leaves ? end : leaves;
		if (from < end)
			broad_phase_walk(p, k, t, from, end, 0x7fffffff);
	}
}

#endif
