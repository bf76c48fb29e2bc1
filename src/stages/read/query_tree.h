// SPDX-License-Identifier: MIT
// query_tree.h -- builds trees with tight boxes at the current poses, and searches them for the nearest leaves.
//
// Queries have their own boxes over the leaves of the broad phase, computed on request and never read by a step. A
// search visits near nodes first, and skips nodes that are farther than the best result so far (docs/design/queries.md).
#ifndef QUERY_TREE_H
#define QUERY_TREE_H
#include "stages/broad_phase/leaf.h"
#include "stages/broad_phase/transform.h"
#include "stages/geometry/filter.h"
#include "stages/tree/tree.h"

#define QUERY_MARGIN  LINEAR_SLOP // m: margin of a box, larger than any rounding error along the path of a query
#define QUERY_SPACING 4.0e-7f     // margin for rounding, as a fraction of the coordinates

// Returns the box around the motion of a collidable from the start of the step to a pose. A rotation moves points off
// the straight line by less than their distance from the center of mass times 1 minus the cosine of the rotation.
INLINE Float4 query_way_box(const Pools* p, int k, WorldShape at)
{
	const GLOBAL Attribute* shape = p->attribute + at.attribute;
	WorldShape start = p->world_shape[k];
	float out = absolute(at.x) + absolute(at.y), reach = shape->reach + absolute(at.center_x) + absolute(at.center_y);
	float bulge = reach * (1.0f - (start.c * at.c + start.s * at.s));
	return box_union(world_box(at, shape, QUERY_MARGIN + QUERY_SPACING * out + bulge),
	                 world_box(start, shape, QUERY_MARGIN + QUERY_SPACING * out + bulge));
}

// Returns whether a collidable at pose `at` certainly is in its box of the step. That box is larger by half the
// speculative distance than the collidable at the start of the step. It is empty for a new collidable.
INLINE int query_holds(const Pools* p, int k, WorldShape at)
{
	WorldShape start = p->world_shape[k];
	float turn = absolute(start.c * at.s - start.s * at.c) + absolute(1.0f - (start.c * at.c + start.s * at.s));
	float shift = absolute(at.x - start.x) + absolute(at.y - start.y) + p->attribute[at.attribute].reach * turn;
	return shift <= 0.5f * SPECULATIVE_DISTANCE && !box_is_empty(p->box[k]);
}

// Returns the box of a collidable at a pose, with the margin for rounding.
INLINE Float4 query_box_at(const Pools* p, WorldShape at)
{
	float out = absolute(at.x) + absolute(at.y);
	return world_box(at, p->attribute + at.attribute, QUERY_MARGIN + QUERY_SPACING * out);
}

// Returns the bit of QueryLeaf.kinds of a kind of collidables, KIND_*.
INLINE Word query_kind(int kind) { return kind & KIND_SENSOR ? LEAF_SENSOR : 1u << (kind - 1); }

// Returns the row of collidable k at a pose. kinds: as QueryLeaf.kinds.
INLINE QueryLeaf query_leaf_of(WorldShape at, int k, Word kinds)
{
	QueryLeaf seen;
	seen.x = at.x;
	seen.y = at.y;
	seen.c = at.c;
	seen.s = at.s;
	seen.attribute = at.attribute;
	seen.body = at.body;
	seen.collidable = k;
	seen.kinds = kinds;
	return seen;
}

// Writes the row and the box of the leaf of collidable k. place: number of the leaf; kind: kind of the collidable.
INLINE void query_leaf_write(const Pools* p, const GLOBAL Tree* tree, int place, int k, int kind)
{
	WorldShape at = collidable_place(p, k);
	Filter filter = p->filter[k];
	Float4 box;
	float out = absolute(at.x) + absolute(at.y);
	if (!(p->argument & TREE_STALE) && query_holds(p, k, at))
		box = box_grow(p->box[k], QUERY_SPACING * out);
	else if (p->argument & TREE_PATHS)
		box = query_way_box(p, k, at);
	else
		box = query_box_at(p, at);
	Word kinds = query_kind(kind) | (filter.category && filter.mask ? LEAF_LISTENS : 0u);
	p->query_leaf_row[tree->leaf_begin + place] = query_leaf_of(at, k, kinds);
	box_pack(p->query_box, tree->begin[0] + place, box);
}

// Item: a leaf. argument: the tree, and TREE_* bits.
KERNEL(query_leaf)
{
	int t = p->argument & 1;
	const GLOBAL Tree* tree = p->tree + t;
	int k = i < tree->leaves ? p->leaf[tree->leaf_begin + i] : 0;
	int kind = i < tree->leaves ? p->collidable_kind[k] : KIND_DEAD;
	if (tree_contains(p, t, kind))
		query_leaf_write(p, tree, i, k, kind);
	else
		box_pack(p->query_box, tree->begin[0] + i, box_empty());
}

// Item: a collidable of an active group, in a world that sleeps. Writes its leaf in tree 0, and lists the node above.
// argument: TREE_* bits.
KERNEL(query_leaf_active)
{
	const GLOBAL Tree* tree = p->tree;
	int k = listed_item(p, GROUPS_OF_COLLIDABLES, i), kind = p->collidable_kind[k], place = tree_place(p, tree, k);
	if (place < 0)
		return;
	if (tree_contains(p, 0, kind))
		query_leaf_write(p, tree, place, k, kind);
	else
		box_pack(p->query_box, tree->begin[0] + place, box_empty());
	tree_mark_above(p, tree, 1, place);
}

// Empties the lists of nodes, which the last step has used.
KERNEL(query_stale_none)
{
	for (int level = 0; level < MAX_LEVELS; ++level)
		p->counters->stale_nodes[level] = 0;
	(void)i;
}

// Item: a node of a level, or with TREE_STALE_ONLY a listed node. Computes the box around its children. argument: the
// tree, TREE_STALE_ONLY, the level.
KERNEL(query_node)
{
	int level = RUN_HIGH(p->argument);
	if (RUN_LOW(p->argument) & TREE_STALE_ONLY)
		i = tree_stale_node(p, level, i);
	tree_join(p->query_box, p->tree + (RUN_LOW(p->argument) & 1), level, i);
}

INLINE int query_accepts(const Pools* p, const GLOBAL QueryPlan* plan, QueryLeaf seen, int ignored)
{
	if (!(plan->kinds & seen.kinds & ~LEAF_LISTENS) || seen.body == ignored)
		return 0;
	if (plan->all)
		return (seen.kinds & LEAF_LISTENS) != 0;
	Filter filter = p->filter[seen.collidable];
	return (plan->mask & filter.category) && (plan->category & filter.mask);
}

// Capacity of the stack of groups of eight siblings that remain to be visited. The nearest group is on top. Each visit
// removes one group and adds up to eight.
#define QUERY_GROUPS (2 + (ARITY - 1) * MAX_LEVELS + 6)

// Returns the code of a group: tree in bit 31, level from bit 27 on, number below.
INLINE Word query_group(int tree, int level, int number) { return (Word)tree << 31 | (Word)level << 27 | (Word)number; }

typedef struct
{
	Word group[QUERY_GROUPS];
	float apart[QUERY_GROUPS]; // lower bound of the fraction, or of the squared distance, of leaves below the group
	int count;
} QueryTraversal;

// Returns the kinds, as bits of QueryLeaf.kinds, that a tree may contain.
INLINE Word query_kinds(int t) { return t == 1 ? 1u << (KIND_STATIC - 1) | LEAF_SENSOR : ~(1u << (KIND_STATIC - 1)); }

INLINE void query_begin(const Pools* p, QueryTraversal* traversal, Word kinds)
{
	traversal->count = 0;
	for (int t = 1; t >= 0; --t)
	{
		if (p->tree[t].leaves == 0 || !(kinds & query_kinds(t)))
			continue;
		traversal->group[traversal->count] = query_group(t, p->tree[t].top, 0);
		traversal->apart[traversal->count] = 0.0f;
		++traversal->count;
	}
}

// Adds a group for each child in the mask `hits`, the nearest child on top. first: code of the group of child 0.
INLINE void query_push(QueryTraversal* traversal, Word hits, const float apart[ARITY], Word first)
{
	int base = traversal->count;
	for (int k = 0; k < ARITY; ++k)
	{
		if (!(hits >> k & 1))
			continue;
		int place = traversal->count++;
		for (; place > base && traversal->apart[place - 1] < apart[k]; --place)
		{
			traversal->apart[place] = traversal->apart[place - 1];
			traversal->group[place] = traversal->group[place - 1];
		}
		traversal->apart[place] = apart[k];
		traversal->group[place] = first + (Word)k;
	}
}

#endif
