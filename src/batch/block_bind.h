// SPDX-License-Identifier: MIT
// block_bind.h -- writes the lists of channels to the pools of a block, and makes room for their rows.
#ifndef BLOCK_BIND_H
#define BLOCK_BIND_H
#include "batch/block_state.h"

// Writes the lists of channels to the pools. sets: CHANNEL_LISTS lists, which outlive the block.
scree_status block_bind(Block* block, const ChannelSet* sets, int templates);

#endif
