// SPDX-License-Identifier: MIT
// tree_maintenance.h -- maintains the trees of the broad phase on the host: lists leaves, and decides when to sort.
#ifndef TREE_MAINTENANCE_H
#define TREE_MAINTENANCE_H
#include "step/pipeline_state.h"

// Returns `count`, a number of leaves or of nodes of a level, rounded up to a multiple of ARITY.
int tree_padded(int count);
int tree_nodes(int leaves);

// Inserts a collidable, whose row must be written before the next step, into tree t (0: moving, 1: static).
scree_status tree_insert(Pipeline* pipeline, int t, int collidable);
// Reverts the last tree_insert of a collidable, because its slot is freed again.
void tree_withdraw(Pipeline* pipeline, int collidable);
void tree_touch(Pipeline* pipeline, int t);
// Removes a collidable from tree t. The collidable was destroyed, or moved to the other tree.
void tree_leave(Pipeline* pipeline, int t, int collidable);
scree_status tree_upload(Pipeline* pipeline);
bool tree_wants_order(const TreeState* state);

// Returns whether boxes that jump in this step will probably disorder the leaves, so that the leaves must be sorted.
bool tree_churns(const TreeState* state);

// Adds the changed boxes and the wasted node visits of a step to the sums of a tree. Must be called after the step.
void tree_count(TreeState* state, const Counters* counters, int t);

// Removes dead leaves from the number of leaves. After the device has sorted the leaves, the dead ones are the last.
scree_status tree_ordered(Pipeline* pipeline, int t);

// tree_save reads the leaves into memory of scree_allocate before pools grow; tree_restore writes them back afterwards.
scree_status tree_save(Pipeline* pipeline, int** leaves);
scree_status tree_restore(Pipeline* pipeline, int* leaves);

#endif
