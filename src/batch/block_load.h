// SPDX-License-Identifier: MIT
// block_load.h -- puts worlds of a block into the states of rows.
#ifndef BLOCK_LOAD_H
#define BLOCK_LOAD_H
#include "batch/block_stage.h"

// Puts the worlds of the copies of a block into the states of their rows, which were checked.
scree_status block_load(Block* block, const RowWork* work);

#endif
