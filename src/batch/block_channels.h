// SPDX-License-Identifier: MIT
// block_channels.h -- moves rows of inputs and outputs between the memory of the user and the pools of a block.
#ifndef BLOCK_CHANNELS_H
#define BLOCK_CHANNELS_H
#include "batch/block_state.h"

// Returns whether rows go through Block.converted, because they are converted, or not adjacent in the memory of the user.
bool block_converts(const Block* block, const ChannelSet* set);

// Writes the touches of `rows` worlds that are new, before their first step. bits: CHANNEL_*.
scree_status block_write_touches(Block* block, int bits, int rows);

// Checks the masses of a list (own_inputs_check). mask: per world of the batch, 0 for worlds that are not reset; null: all.
scree_status block_check_masses(Block* block, int list, const uint8_t* mask, const char* function);

// Sets the parameters of the worlds that run, which are inputs of a step.
scree_status block_set_parameters(Block* block);

// Copies the inputs of a step from shared memory, and checks their ranges on the device.
scree_status block_check_shared(Block* block, const char* function);

// Applies the other inputs of a step, except targets.
scree_status block_apply_inputs(Block* block);
// Applies forces and torques again, before the second and later steps of a call.
scree_status block_apply_again(Block* block);

// Sets the members of Block.request for targets of the next step. first: true for the first step of a call, in which they act.
void block_aim(Block* block, bool first);

// Applies the inputs of a reset to the worlds of the first copies and rows of the block.
scree_status block_apply_reset(Block* block, int resets);

// Writes the touches of the running worlds of Block.copies, which have other states, so that the next outputs tell which
// are new. Changes Block.copies.
scree_status block_begin_touches(Block* block, int copies);

// Computes the outputs of worlds that run, and writes all outputs to the memory of the user.
scree_status block_write_outputs(Block* block);

#endif
