// SPDX-License-Identifier: MIT
// tree_maintenance.h -- the host's part of the broad phase's trees: their leaves, and the decision when to sort them.
#ifndef TREE_MAINTENANCE_H
#define TREE_MAINTENANCE_H
#include "step/pipeline_state.h"

// Returns a number of leaves or nodes of a level, rounded up to whole groups of siblings.
int tree_padded(int count);
int tree_nodes(int leaves);

// Inserts a leaf into tree t (0: moving, 1: static), unless it has one. Its row must be written before the next step.
scree_status tree_insert(Pipeline* pipeline, int t, int collidable);
// Reverts the last tree_insert of a collidable whose slot is freed again.
void tree_withdraw(Pipeline* pipeline, int collidable);
void tree_touch(Pipeline* pipeline, int t);
// Removes a collidable that was destroyed, or moved to the other tree, from tree t.
void tree_leave(Pipeline* pipeline, int t, int collidable);
scree_status tree_upload(Pipeline* pipeline);
bool tree_wants_order(const TreeState* state);

// Returns whether boxes that jump in this step will cause that much disorder.
bool tree_churns(const TreeState* state);

// Counts the wasted node visits of the traversals, after a step.
void tree_count(TreeState* state, const Counters* counters, int t);

// Drops dead leaves, which are the last ones after the leaves were sorted.
scree_status tree_ordered(Pipeline* pipeline, int t);

// Keep the leaves when pools grow: tree_save reads them before, into scree_allocate memory; tree_restore writes them.
scree_status tree_save(Pipeline* pipeline, int** leaves);
scree_status tree_restore(Pipeline* pipeline, int* leaves);

#endif
