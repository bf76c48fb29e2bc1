// SPDX-License-Identifier: MIT
// block_gravity.h -- gives the worlds of a block their gravity, which may differ.
#ifndef BLOCK_GRAVITY_H
#define BLOCK_GRAVITY_H
#include "batch/block_state.h"

// Notes that the gravity of rows may have changed.
void block_gravity_changes(Block* block, int first, int end);

// Uploads the gravity of the worlds, and values that depend on it, if they changed. Block.request has the length of the steps
// that follow.
scree_status block_gravity(Block* block);

// Returns the gravity of a world, m/s^2.
scree_vec block_world_gravity(const Block* block, int row);

// Wakes the bodies of those worlds whose gravity differs from the one before, m/s^2. rows: rows of the worlds, null for the
// first `count` rows. before: null for the gravity of the templates.
scree_status block_wake(Block* block, const int* rows, const scree_vec* before, int count);

// Sets the gravity of all worlds of the batch, m/s^2; null: that of the templates. The array must stay valid. Wakes worlds
// whose gravity changes.
scree_status block_set_gravity(Block* block, scree_vec* gravity);

#endif
