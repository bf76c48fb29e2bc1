// SPDX-License-Identifier: MIT
// world_block.h -- steps the worlds of a batch that share pools: all of them on a GPU, some of them for a worker of a CPU.
#ifndef WORLD_BLOCK_H
#define WORLD_BLOCK_H
#include "batch/block_state.h"

// Opens a block on a backend, which the block closes. templates: array of `count`. first, worlds: range of places of `order`,
// whose worlds have the same tuning. contact_limit: for each world, the maximum number of contacts, 0 for the default. On
// failure block_close must follow.
scree_status block_open(Block* block, Backend* backend, const Template* templates, int count, int* template_of,
                        const int* next_of, const WorldOrder* order, int first, int worlds, int contact_limit);
void block_close(Block* block);

// Puts worlds back to their templates. Worlds that were paused then run. mask: per world of the batch, 0 for worlds that
// stay; null: all.
scree_status block_reset(Block* block, const uint8_t* mask);

// Pauses worlds, and lets all others run. mask: per world of the batch, 0 for worlds that run; null: all run.
scree_status block_pause(Block* block, const uint8_t* mask);

// Steps the worlds that run. Pauses those whose contacts are too many, and counts them in Block.crowded.
scree_status block_step(Block* block, float dt, int substeps, int steps);

// Writes the hashes of the worlds of the block to those of the batch.
scree_status block_hash(Block* block, uint64_t* hashes);

// Writes the counters of the worlds of the block to those of the batch.
scree_status block_counters(Block* block, BayCounters* counters);

#endif
