// SPDX-License-Identifier: MIT
// block_pools.h -- writes templates, and data that all worlds of a template share, into the pools of a block.
#ifndef BLOCK_POOLS_H
#define BLOCK_POOLS_H
#include "batch/block_state.h"

// templates: number of templates of the batch. Pipeline.bays is set; the counters on the host are those to begin with.
scree_status block_fill(Block* block, int templates);

#endif
