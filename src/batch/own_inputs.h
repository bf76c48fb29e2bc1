// SPDX-License-Identifier: MIT
// own_inputs.h -- applies rows of inputs to the own values and the gravity of worlds of a block.
#ifndef OWN_INPUTS_H
#define OWN_INPUTS_H
#include "batch/block_state.h"
#include "batch/own_values.h"

// Sets the gravity of a world to that of a row of inputs, in metres. block_wake must follow.
void own_inputs_pull(Block* block, const ChannelSet* set, int row, const float* values);

// Fails if masses of such a row make a body heavy (Pipeline.heavy), but those of the template are not: this would change the bits of all
// worlds of the block. from, own: template and own values of the world before.
scree_status own_inputs_check(const ChannelSet* set, const char* function, const Template* from, Own own, int number,
                              const float* values, int world);

// Applies the other parameters of such a row to a world that runs. block_own_send must follow.
scree_status own_inputs_set(Block* block, const ChannelSet* set, int row, const float* values);

#endif
