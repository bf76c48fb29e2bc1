// SPDX-License-Identifier: MIT
// block_stage.h -- the spare bays of a block through which the states of worlds come and go.
//
// Their items are adjacent, so one read or write of each pool serves many worlds.
#ifndef BLOCK_STAGE_H
#define BLOCK_STAGE_H
#include "batch/block_state.h"
#include "batch/world_row.h"

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

typedef struct // the states in the spare bays of a block
{
	Block* block;
	const RowWork* work;
	int count, copies;    // numbers of bays in use, and of copies from them
	char* items;          // items of one pool, of all these bays
	CollidablePair* pair; // pairs of collidables of their contacts
	BayState* states;
	Bay* bays;
	RowHead* heads;
	char** rows;
	const Template** templates;
	int* origins; // block_own_origin of the worlds that are saved
} Staged;

// Allocates memory for the states in the spare bays of a block. staged_close must follow, also after a failure.
scree_status staged_open(Staged* s, Block* block, const RowWork* work);
void staged_close(Staged* s);

// Returns the first item of a pool in the spare bays, and sets *count to the number of items of a bay.
int staged_items(const Staged* s, PoolId pool, int* count);

// Reads the items of a pool in the spare bays that are in use.
scree_status staged_read(Staged* s, PoolId pool, void* items);

// Copies the visits to sensors from the spare bays to the rows (saves), or from the rows to the spare bays.
scree_status staged_visits(Staged* s, bool saves);

// Return the row of a copy; the copies of a block, in the order of RowWork.order; the template of a world of the block.
char* work_row(const RowWork* work, int copy);
const int* work_copies(const Block* block, const RowWork* work, int* count);
const Template* block_world_template(const Block* block, int world);

#endif
