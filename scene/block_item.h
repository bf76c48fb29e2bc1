// SPDX-License-Identifier: MIT
// block_item.h -- what differs from one item of a scene's block to the next, for the expressions of the scene.
#ifndef BLOCK_ITEM_H
#define BLOCK_ITEM_H
#include <stdint.h>

typedef struct
{
	const double* indices; // values of the repeat indices
	uint64_t seed;         // of the scene
	uint64_t number;       // of the item within its repeat block
} Item;

#endif
