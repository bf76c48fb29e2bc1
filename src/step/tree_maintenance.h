// SPDX-License-Identifier: MIT
// tree_maintenance.h -- maintains the trees of the broad phase on the host: lists leaves, and decides when to sort.
#ifndef TREE_MAINTENANCE_H
#define TREE_MAINTENANCE_H
#include "step/pipeline_state.h"

// Returns `count`, a number of leaves or of nodes of a level, rounded up to a multiple of ARITY.
int tree_padded(int count);
int tree_nodes(int leaves);

// Inserts a collidable into tree t (0: moving, 1: static). The collidable's row must be written before the next step.
scree_status tree_insert(Pipeline* pipeline, int t, int collidable);
// Reverts the last tree_insert of a collidable whose slot is freed because its creation failed.
void tree_withdraw(Pipeline* pipeline, int collidable);
// Lets the next step and the next query compute all boxes of tree t again.
void tree_touch(Pipeline* pipeline, int t);
// Lets the next query write the rows of tree t again, which name the attributes of collidables. Boxes of the step stay.
void tree_forget(Pipeline* pipeline, int t);
// Removes a collidable from tree t. The collidable was destroyed, or moved to the other tree.
void tree_leave(Pipeline* pipeline, int t, int collidable);
// Reserves the host's memory for a number of collidables.
scree_status tree_reserve(Pipeline* pipeline, int collidables);
// Sets the leaves of tree t of a restored world, in an order that needs no sort. Memory and pools have room for them.
scree_status tree_restore_leaves(Pipeline* pipeline, int t, const int* leaves, int count);
scree_status tree_upload(Pipeline* pipeline);
bool tree_wants_order(const TreeState* state);

// Returns whether boxes that jump in this step will probably disorder the leaves, so that the leaves must be sorted.
bool tree_churns(const TreeState* state);

// Adds the changed boxes and wasted node visits of a step to the sums of tree t. Must be called after the step.
void tree_count(TreeState* state, const Counters* counters, int t);

// Subtracts the dead leaves of tree t from its number of leaves, after the device has sorted them behind all others.
scree_status tree_ordered(Pipeline* pipeline, int t);

// tree_save reads the leaves into memory, which the caller frees, before pools grow; tree_restore writes them back.
scree_status tree_save(Pipeline* pipeline, int** leaves);
scree_status tree_restore(Pipeline* pipeline, int* leaves);

#endif
