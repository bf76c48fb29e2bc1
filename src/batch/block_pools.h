// SPDX-License-Identifier: MIT
// block_pools.h -- writes templates, and data that all worlds of a template share, into the pools of a block.
#ifndef BLOCK_POOLS_H
#define BLOCK_POOLS_H
#include "batch/block_state.h"

// Fills the pools. Pipeline.bays is set; the counters on the host are those to begin with.
scree_status block_fill(Block* block);

// Sets the number of live bays, after worlds moved to other bays, and what depends on the templates of these bays: lists of
// kinematic bodies and of pairs that never touch, chains.
scree_status block_count(Block* block, int live);

// Writes the chains of the live bays again if those of some world have changed.
scree_status block_refresh_chains(Block* block);

#endif
