// SPDX-License-Identifier: MIT
// block_own.h -- changes the own values of the worlds of a block: masses, surfaces, disabled bodies and joints.
#ifndef BLOCK_OWN_H
#define BLOCK_OWN_H
#include "batch/block_state.h"

// Makes memory for the own values of all worlds of a block, which are at first those of their templates.
scree_status block_own_open(Block* block);
void block_own_close(Block* block);

// Sets the own values of a world to those of a row that was loaded into it, or to those of its template (null). The pools have
// them already, but for the indices of attributes. block_own_send must follow.
scree_status block_own_take(Block* block, int row, const char* values);

// Sends the changes to the device.
scree_status block_own_send(Block* block);

// Requests a search for the chains of a world, which a world alone makes at the beginning of its next step.
void block_own_request(Block* block, int row);

// Searches for the chains of worlds that run, before a step, if their masses, bodies or joints have changed.
scree_status block_own_search(Block* block);

// Returns the own values of a world, and what they add to its hash.
char* block_own_values(const Block* block, int row);
uint64_t block_own_hash(const Block* block, int row);

// Returns the index in the pools of the attribute that is attribute 0 of a world.
int block_own_origin(const Block* block, int row);

// Returns the chains of a world.
const ChainSearch* block_own_chains(const Block* block, int row);

// Returns whether chains of some world differ from those of its template.
bool block_own_has_chains(const Block* block);

#endif
