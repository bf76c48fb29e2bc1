// SPDX-License-Identifier: MIT
// tree.h -- the host's share of the broad phase's trees: which leaves there are, and when to put them in order.
#ifndef TREE_HOST_H
#define TREE_HOST_H
#include "pipeline.h"

// nodes of all levels of a tree of so many leaves, padding included
int tree_nodes(int leaves);

// sends new leaves to the device
scree_status tree_flush(scree_world* world);

// whether the leaves of a tree are so far out of order that sorting them pays
bool tree_wants_order(const TreeState* state);

// whether boxes that jump in this step will put them so far out of order
bool tree_churns(const TreeState* state);

// after a step: what its walks visited in vain
void tree_count(TreeState* state, const Counters* counters, int t);

// after the leaves were sorted: dead ones, which are last, are dropped
scree_status tree_ordered(scree_world* world, int t);

// The leaves lie elsewhere when the pools grow: read before, written after. leaves is scree_allocate'd by tree_save.
scree_status tree_save(scree_world* world, int** leaves);
scree_status tree_restore(scree_world* world, int* leaves);

#endif
