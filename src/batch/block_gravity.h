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

#endif
