// SPDX-License-Identifier: MIT
// block_item.h -- values that differ between the items of a scene's block, for the expressions of the scene.
#ifndef BLOCK_ITEM_H
#define BLOCK_ITEM_H
#include <stdint.h>

typedef struct
{
	const double* indices; // values of the repeat indices
	uint64_t seed;         // seed of the scene
	uint64_t number;       // number of the item within its repeat block
} Item;

#endif
