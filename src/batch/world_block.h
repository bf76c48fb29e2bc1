// SPDX-License-Identifier: MIT
// world_block.h -- steps the worlds of a batch that share pools: all of them on a GPU, some of them for a worker of a CPU.
#ifndef WORLD_BLOCK_H
#define WORLD_BLOCK_H
#include "batch/block_state.h"

// Opens a block on a backend, which the block closes. templates: array of `count`. On failure block_close must follow.
scree_status block_open(Block* block, Backend* backend, const Template* templates, int count, const int* template_of,
                        int first, int worlds);
void block_close(Block* block);

// Puts worlds back to their templates. mask: per world of the batch, 0 for worlds that stay; null: all.
scree_status block_reset(Block* block, const uint8_t* mask);

scree_status block_step(Block* block, float dt, int substeps, int steps);

// Writes the hashes of the worlds of the block to those of the batch.
scree_status block_hash(Block* block, uint64_t* hashes);

#endif
