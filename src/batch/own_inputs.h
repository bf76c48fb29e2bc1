// SPDX-License-Identifier: MIT
// own_inputs.h -- applies rows of inputs to the own values and the gravity of worlds of a block.
#ifndef OWN_INPUTS_H
#define OWN_INPUTS_H
#include "batch/block_state.h"

// Sets the gravity of a world to that of a row of inputs, in metres. block_wake must follow.
void own_inputs_pull(Block* block, const ChannelSet* set, int row, const float* values);

// Applies the other parameters of such a row to a world that runs. block_own_send must follow.
scree_status own_inputs_set(Block* block, const ChannelSet* set, int row, const float* values);

#endif
