// SPDX-License-Identifier: MIT
// block_rows.h -- copies the states of single worlds of a block to rows, and back.
#ifndef BLOCK_ROWS_H
#define BLOCK_ROWS_H
#include "batch/block_state.h"

typedef struct // copies of states between worlds of a batch and rows
{
	const char* function;
	const Block* blocks;   // first block of the batch
	const int32_t* worlds; // for each copy: the world
	const int* order;      // indices of copies, in the order of blocks
	const int* begin;      // for each block: index in `order` of its first copy; then the end
	char* rows;
	size_t row_bytes; // distance of rows; 0: all copies have the same row
	size_t bytes;     // largest size of a row
	uint64_t version; // row_version
} RowWork;

// Returns the size of a row of any world of the block.
size_t block_row_bytes(const Block* block);

// Writes the rows of the copies of a block.
scree_status block_save(Block* block, const RowWork* work);

// Checks the rows of the copies of a block. Changes nothing.
scree_status block_check(Block* block, const RowWork* work);

// Puts the worlds of the copies of a block into the states of their rows, which were checked.
scree_status block_load(Block* block, const RowWork* work);

#endif
