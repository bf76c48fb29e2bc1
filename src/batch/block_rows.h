// SPDX-License-Identifier: MIT
// block_rows.h -- copies the states of single worlds of a block to rows, and checks rows.
#ifndef BLOCK_ROWS_H
#define BLOCK_ROWS_H
#include "batch/block_stage.h"

// Returns the size of a row of any world of the block.
size_t block_row_bytes(const Block* block);

// Writes the rows of the copies of a block.
scree_status block_save(Block* block, const RowWork* work);

// Checks the rows of the copies of a block. Changes nothing.
scree_status block_check(Block* block, const RowWork* work);

#endif
