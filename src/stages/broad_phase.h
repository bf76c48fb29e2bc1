// SPDX-License-Identifier: MIT
// broad_phase.h -- moved boxes against the trees: the set of new pairs.
//
// A contact exists exactly as long as the enlarged boxes of its collidables overlap. So a pair is new when its boxes
// overlap now and did not before this step's transform; no table of known pairs is needed. A pair of which both moved
// is taken by the one of the lower index.
#ifndef BROAD_PHASE_H
#define BROAD_PHASE_H
#include "stages/filter.h"
#include "stages/tree.h"

INLINE void broad_phase_leaf(const Pools* p, int i, int j)
{
	// most neighbors are known ones
	if (box_overlap(p->old_box[i], p->old_box[j]) || i == j || ((p->moved[j] & MOVED_BOX) && j < i))
		return;
	int body = p->collidable_body[i];
	if (body >= 0 && body == p->collidable_body[j])
		return;
	if (!kinds_meet(p->collidable_kind[i], p->collidable_kind[j]) || !filter_accepts(p->filter[i], p->filter[j]))
		return;
	int place = atomic_add_int(&p->counters->pairs, 1);
	int a = i < j ? i : j, b = i < j ? j : i;
	if (place < p->step.pair_capacity)
		p->key[place] = (Word64)a << p->step.key_bits | (Word64)b;
}

// Visits the leaves of tree t that overlap the box of collidable i.
INLINE void broad_phase_tree(const Pools* p, int i, int t)
{
	const GLOBAL Tree* tree = p->tree + t;
	if (tree->leaves == 0)
		return;
	Float4 box = p->box[i];
	TreeWalk walk = tree_walk(p, tree, box);
	for (int j = tree_next(p, tree, box, &walk); j >= 0; j = tree_next(p, tree, box, &walk))
		broad_phase_leaf(p, i, j);
}

// the search anew, after a buffer grew
STAGE(broad_phase_begin)
{
	p->counters->pairs = 0;
	p->counters->created = 0;
	p->counters->stalled = 0;
	(void)i;
}

STAGE(broad_phase)
{
	int k = p->moved_list[i], kind = p->collidable_kind[k];
	broad_phase_tree(p, k, 0);
	if (kind == KIND_DYNAMIC || kind == KIND_FREE)
		broad_phase_tree(p, k, 1);
}

#endif
