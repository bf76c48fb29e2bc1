// SPDX-License-Identifier: MIT
// block_item.h -- the values that an expression may use and that differ between the items of a block.
#ifndef BLOCK_ITEM_H
#define BLOCK_ITEM_H
#include "platform/exact_floats.h"
#include <stdint.h>

typedef struct
{
	const double* indices; // values of the loop indices
	uint64_t seed;         // seed of the scene
	uint64_t number;       // number of the item in its block, or number of a change of churn; random() depends on it
} Item;

#endif
