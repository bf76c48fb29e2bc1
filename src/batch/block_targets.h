// SPDX-License-Identifier: MIT
// block_targets.h -- moves kinematic bodies of worlds of a block to the pending targets of their templates.
#ifndef BLOCK_TARGETS_H
#define BLOCK_TARGETS_H
#include "batch/block_state.h"

// Allocates what the targets of the templates of the block need.
scree_status block_targets_open(Block* block);
void block_targets_close(Block* block);

// Gives a world all targets of its template, without those that inputs of a reset replace.
void block_targets_begin(Block* block, int row);

// Removes the targets that inputs of a step replace, from the worlds that run.
void block_targets_replace(Block* block);

// Return and set the pending targets of a world. set: as in template_targets.h.
uint64_t block_targets_of(const Block* block, int row);
void block_targets_set(Block* block, int row, uint64_t set);

// Adds the commands for the pending targets to the request of a step.
scree_status block_targets_request(Block* block);

// Ends the targets that a step has reached.
void block_targets_end(Block* block);

#endif
