// SPDX-License-Identifier: MIT
// tree.h -- the host's share of the broad phase's trees: which leaves there are, and when to put them in order.
#ifndef TREE_HOST_H
#define TREE_HOST_H
#include "step/state.h"

// nodes of all levels of a tree of so many leaves, padding included
int tree_nodes(int leaves);

// Makes sure that tree t (0: moving, 1: static) has a leaf for a collidable, which belongs there from now on. Its row is
// written by the time of the next step.
scree_status tree_insert(Pipeline* pipeline, int t, int collidable);
// Takes back the leaf that was inserted last: its slot is free again, and the pools may have no room for it.
void tree_withdraw(Pipeline* pipeline, int collidable);
// The box of some collidable of tree t changed by the user's doing.
void tree_touch(Pipeline* pipeline, int t);
// The same; the collidable was destroyed, or went to the other tree.
void tree_leave(Pipeline* pipeline, int t, int collidable);

// sends new leaves to the device
scree_status tree_upload(Pipeline* pipeline);

// whether the leaves of a tree are so far out of order that sorting them pays
bool tree_wants_order(const TreeState* state);

// whether boxes that jump in this step will put them so far out of order
bool tree_churns(const TreeState* state);

// after a step: what its walks visited in vain
void tree_count(TreeState* state, const Counters* counters, int t);

// after the leaves were sorted: dead ones, which are last, are dropped
scree_status tree_ordered(Pipeline* pipeline, int t);

// The leaves lie elsewhere when the pools grow: read before, written after. leaves is scree_allocate'd by tree_save.
scree_status tree_save(Pipeline* pipeline, int** leaves);
scree_status tree_restore(Pipeline* pipeline, int* leaves);

#endif
