// SPDX-License-Identifier: MIT
// leaf.h -- updates single leaves of the tree of moving collidables, in a world that sleeps.
#ifndef LEAF_H
#define LEAF_H
#include "stages/edit/active.h"
#include "stages/tree/tree.h"

// Returns the leaf of a collidable in tree 0, in a world that sleeps; -1 if it has none.
INLINE int tree_place(const Pools* p, const GLOBAL Tree* tree, int collidable)
{
	int place = p->leaf_place[collidable]; // undefined for a collidable that never had a leaf
	return place >= 0 && place < tree->leaves && p->leaf[tree->leaf_begin + place] == collidable ? place : -1;
}

// Item: a leaf of tree 0 that was appended since the last step or query, in a world that sleeps.
KERNEL(leaf_append) { p->leaf_place[p->leaf[p->tree->leaf_begin + i]] = i; }

// Item: a collidable of an active group, in a world that sleeps, after the user created, destroyed or changed some.
// Updates the box of its leaf in tree 0, and lists the node above.
KERNEL(leaf_active)
{
	const GLOBAL Tree* tree = p->tree;
	int k = listed_item(p, GROUPS_OF_COLLIDABLES, i), kind = p->collidable_kind[k], place = tree_place(p, tree, k);
	if (place < 0)
		return;
	box_pack(p->node_box, tree->begin[0] + place, tree_contains(p, 0, kind) ? p->box[k] : box_empty());
	tree_mark_above(p, tree, 1, place);
}

// Item: an updated collidable, in a world that sleeps. Updates the box of its leaf in tree 0, and lists the node above.
KERNEL(leaf_update)
{
	const GLOBAL Tree* tree = p->tree;
	int k = p->updated_list[i], place = p->leaf_place[k];
	if (tree_of_kind(p->collidable_kind[k]) != 0)
		return;
	box_pack(p->node_box, tree->begin[0] + place, p->box[k]);
	tree_mark_above(p, tree, 1, place);
}

#endif
