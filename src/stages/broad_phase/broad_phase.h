// SPDX-License-Identifier: MIT
// broad_phase.h -- finds the new pairs by traversals of the trees with the boxes that changed.
//
// A contact exists as long as the enlarged boxes of its collidables overlap. So a pair is new if its boxes overlap now
// and did not before this step's transform. If both boxes changed, the traversal of the collidable with the lower index
// finds the pair. A traversal visits leaves in rising order, so another work-item can continue it at any leaf.
#ifndef BROAD_PHASE_H
#define BROAD_PHASE_H
#include "pools/bays.h"
#include "stages/rules/apart.h"
#include "stages/tree/tree.h"
#include "stages/tree/tree_packet.h"

// Returns a mask of eight leaves without those whose old box overlaps that of collidable i, because such pairs are
// known. Bit 0 is the leaf at place `first`. A GPU loads the eight boxes together, to hide the latency of memory. On a
// CPU the mask stays unchanged, because broad_phase_leaf tests the old boxes.
INLINE Word64 broad_phase_fresh(const Pools* p, int i, int first, Word64 leaves)
{
	int leaf[ARITY];
	Float4 old[ARITY];
	if (FETCHES)
		return leaves;
	for (int k = 0; k < ARITY; ++k)
		leaf[k] = leaves >> k & (Word64)1 ? p->leaf[first + k] : i;
	for (int k = 0; k < ARITY; ++k)
		old[k] = p->old_box[leaf[k]];
	for (int k = 0; k < ARITY; ++k)
		if (box_overlap(p->old_box[i], old[k]))
			leaves &= ~((Word64)1 << k);
	return leaves;
}

// Adds the pair of collidables i and j to the new pairs, unless it is known or may never touch. Returns 0 if the
// traversal must stop, because the contact limit is reached.
INLINE int broad_phase_leaf(const Pools* p, int i, int j)
{
	// early exit: most leaves form known pairs
	if (box_overlap(p->old_box[i], p->old_box[j]) || i == j || ((p->collidable_flags[j] & COLLIDABLE_NEW_BOX) && j < i))
		return 1;
	if (apart_by(p, i, j, APART_PAIR))
		return 1;
	int place = atomic_add_int(&p->counters->pairs, 1);
	int a = i < j ? i : j, b = i < j ? j : i;
	if (place < p->step.pair_capacity)
		p->key[place] = apart_key(p, make_int2(a, b));
	return place < p->step.contact_limit;
}

// Visits the leaves of tree t that overlap the box of collidable i. from, end, nodes: as in TreeTraversal. Returns the
// leaf at which another traversal must continue; 0 if none is needed.
INLINE int broad_phase_traverse(const Pools* p, int i, int t, int from, int end, int nodes)
{
	const GLOBAL Tree* tree = p->tree + t;
	// if the contact limit is exceeded, the step will be refused, so no other pairs are needed
	if (tree->leaves == 0 || read_shared(&p->counters->pairs) > p->step.contact_limit)
		return 0;
	Float4 box = p->box[i];
	TreeTraversal traversal = tree_traverse(p, tree, box, from, end, nodes);
	traversal.movers = p->step.kinematic > 0 && p->collidable_kind[i] == KIND_KINEMATIC;
	for (;;)
	{
		int first = tree_next(p, tree, box, &traversal);
		if (first < 0)
			return first == TREE_LEFT ? traversal.first : 0;
		first += tree->leaf_begin;
		Word64 leaves = broad_phase_fresh(p, i, first, traversal.leaves);
		for (; leaves != 0; leaves &= leaves - (Word64)1)
			if (!broad_phase_leaf(p, i, p->leaf[first + lowest_bit(leaves)]))
				return 0;
	}
}

// Clears the counters of the search for pairs before each search. A search is repeated after a pool has grown.
KERNEL(broad_phase_begin)
{
	p->counters->pairs = 0;
	p->counters->traversals = 0;
	p->counters->rest = 0;
	p->counters->created = 0;
	p->counters->stalled = 0;
	(void)i;
}

// Returns the number of trees that a collidable of a kind must traverse, from tree 0 on. Sensors have no pairs; static
// and kinematic collidables have no pairs in the static tree.
INLINE int broad_phase_trees(int kind)
{
	return kind & KIND_SENSOR ? 0 : kind == KIND_DYNAMIC || kind == KIND_FREE ? 2 : 1;
}

// Traverses tree t for collidable k, up to traversal_nodes nodes. If nodes remain, lists them for broad_phase_rest.
INLINE void broad_phase_alone(const Pools* p, int k, int t)
{
	int from = bay_of_collidable(p, k) * p->step.bays.collidables; // in a batch, leaf i is that of collidable i
	int next = broad_phase_traverse(p, k, t, from, from + p->step.bays.collidables, p->step.traversal_nodes);
	if (next == 0)
		return;
	p->traversal[atomic_add_int(&p->counters->traversals, 1)] = make_int2(2 * k + t, next);
	raise_int(&p->counters->rest, 0x7fffffff);
}

// Processes the leaves that overlap the boxes of a packet. kinematic: mask of the traversals of kinematic collidables;
// alone: mask of the traversals outside the packet, which are skipped. Returns 0 if the contact limit is reached.
INLINE int broad_phase_leaves(const Pools* p, const GLOBAL Tree* tree, const int* collidables, const Float4* boxes,
                              Word kinematic, Word alone, const PacketFront* front)
{
	int traversal[PACKET_LEAVES], leaf[PACKET_LEAVES], count = 0, far = tree->leaves >= FETCH_COLLIDABLES;
	for (int k = 0; k < front->count; ++k)
	{
		int w = packet_traverse(front->node[k]), first = packet_first(front->node[k]);
		Word hits = alone >> w & 1 ? 0 : overlaps8(p->node_box + tree->begin[0] + first, boxes[w]);
		if (kinematic >> w & 1)
			hits &= tree_movers_of(p, tree, 0, first);
		for (; hits != 0; hits &= hits - 1)
		{
			traversal[count] = collidables[w];
			leaf[count] = p->leaf[tree->leaf_begin + first + lowest_bit(hits)];
			if (far)
			{
				fetch_soon(p->old_box + leaf[count]);
				fetch_soon(p->collidable_flags + leaf[count]);
			}
			++count;
		}
		if (count <= PACKET_LEAVES - ARITY && k + 1 < front->count)
			continue;
		for (int n = 0; n < count; ++n)
			if (!broad_phase_leaf(p, traversal[n], leaf[n]))
				return 0;
		count = 0;
	}
	return 1;
}

// Traverses tree t with one packet: up to PACKET_TRAVERSALS collidables of the updated list, beginning at entry i.
INLINE void broad_phase_packet(const Pools* p, int i, int t)
{
	const GLOBAL Tree* tree = p->tree + t;
	if (tree->leaves == 0 || read_shared(&p->counters->pairs) > p->step.contact_limit)
		return;
	int collidables[PACKET_TRAVERSALS],
	    end = i + PACKET_TRAVERSALS < p->counters->updated_boxes ? i + PACKET_TRAVERSALS : p->counters->updated_boxes;
	Float4 boxes[PACKET_TRAVERSALS];
	PacketFront fronts[2];
	Word kinematic = 0, alone = 0;
	fronts[0].count = 0;
	for (int k = i; k < end; ++k)
	{
		int collidable = p->updated_list[k], n = fronts[0].count;
		if (t >= broad_phase_trees(p->collidable_kind[collidable]))
			continue;
		collidables[n] = collidable;
		boxes[n] = p->box[collidable];
		kinematic |= (Word)(p->collidable_kind[collidable] == KIND_KINEMATIC) << n;
		fetch_soon(p->old_box + collidable);
		fronts[0].node[n] = packet_node(n, 0);
		++fronts[0].count;
	}
	int traversals = fronts[0].count, front = 0;
	for (int level = tree->top; level > 0; --level, front ^= 1)
		alone = packet_descend(p, tree, level, boxes, kinematic, alone, fronts + front, fronts + (front ^ 1));
	if (!broad_phase_leaves(p, tree, collidables, boxes, kinematic, alone, fronts + front))
		return;
	for (int k = 0; k < traversals; ++k)
		if (alone >> k & 1)
			broad_phase_alone(p, collidables[k], t);
}

// Item: an updated collidable. On a CPU the first of every PACKET_TRAVERSALS items traverses the trees for all of them,
// as a packet. The chunk of a worker has a multiple of PACKET_TRAVERSALS items, so packets do not cross chunks.
KERNEL(broad_phase)
{
	if (FETCHES && !BATCHED(p))
	{
		for (int t = 0; t < 2 && i % PACKET_TRAVERSALS == 0; ++t)
			broad_phase_packet(p, i, t);
		return;
	}
	int k = p->updated_list[i];
	for (int t = 0; t < broad_phase_trees(p->collidable_kind[k]); ++t)
		broad_phase_alone(p, k, t);
}

// Item: a work-item that helps to complete long traversals. Each traversal gets the same number of work-items, which
// take equal parts of its remaining leaves. If there are more traversals than work-items, a work-item takes several.
KERNEL(broad_phase_rest)
{
	int traversals = p->counters->traversals,
	    parts = traversals < p->step.traversal_items ? p->step.traversal_items / traversals : 1;
	int teams = p->step.traversal_items / parts;
	for (int w = i / parts; w < traversals && i < teams * parts; w += teams)
	{
		Int2 traversal = p->traversal[w];
		int k = traversal.x / 2, t = traversal.x % 2, leaves = p->tree[t].leaves;
		int begin = traversal.y / ARITY, blocks = (leaves - 1) / ARITY + 1 - begin, share = (blocks - 1) / parts + 1;
		int from = ARITY * (begin + share * (i % parts)), end = from + ARITY * share;
		from = from < traversal.y ? traversal.y : from;
		end = end < leaves ? end : leaves;
		if (from < end)
			broad_phase_traverse(p, k, t, from, end, 0x7fffffff);
	}
}

#endif
