// SPDX-License-Identifier: MIT
// tree_maintenance.h -- the host's part of the broad phase's trees: their leaves, and when they are put in order.
#ifndef TREE_MAINTENANCE_H
#define TREE_MAINTENANCE_H
#include "step/pipeline_state.h"

// So many leaves or nodes of a level, rounded up to whole groups of siblings.
int tree_padded(int count);

// nodes of all levels of a tree of so many leaves, padding included
int tree_nodes(int leaves);

// Inserts a leaf for a collidable into tree t (0: moving, 1: static), unless it has one. The row of the collidable must be
// written before the next step.
scree_status tree_insert(Pipeline* pipeline, int t, int collidable);
// Undoes the last tree_insert of a collidable whose slot is freed again.
void tree_withdraw(Pipeline* pipeline, int collidable);
// The user changed the box of some collidable of tree t.
void tree_touch(Pipeline* pipeline, int t);
// A collidable of tree t was destroyed, or moved to the other tree.
void tree_leave(Pipeline* pipeline, int t, int collidable);

// sends new leaves to the device
scree_status tree_upload(Pipeline* pipeline);

// whether the leaves of a tree are so far out of order that sorting them pays
bool tree_wants_order(const TreeState* state);

// whether boxes that jump in this step will disorder them that far
bool tree_churns(const TreeState* state);

// after a step: counts the nodes that its walks visited in vain
void tree_count(TreeState* state, const Counters* counters, int t);

// after the leaves were sorted: dead ones, which are last, are dropped
scree_status tree_ordered(Pipeline* pipeline, int t);

// The leaves move when the pools grow: save reads them before, restore writes them after. leaves is scree_allocate'd by tree_save.
scree_status tree_save(Pipeline* pipeline, int** leaves);
scree_status tree_restore(Pipeline* pipeline, int* leaves);

#endif
