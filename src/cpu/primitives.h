// SPDX-License-Identifier: MIT
// primitives.h -- sort and scan, as jobs whose blocks are shares of the items.
#ifndef PRIMITIVES_H
#define PRIMITIVES_H
#include "platform/threads.h"
#include <stdint.h>

#define RADIX_BITS 8
#define RADIX      (1 << RADIX_BITS)

typedef struct // data that the blocks of a sort or scan share
{
	_Alignas(64) int counts[MAX_WORKERS][RADIX]; // keys of each digit in each block
	int sums[MAX_WORKERS];
	uint64_t *from, *to, mask;
	int *values, count, shift;
	bool moves; // the keys are not all equal in this digit, so they move
} Shared;

// Sorts keys by their bits from low to high - 1, in at most as many blocks as workers; stable. other is scratch.
void sort_keys(Shared* shared, Threads* threads, int blocks, uint64_t* keys, uint64_t* other, int count, int low,
               int high);

// Replaces each of count values by the sum of the values before it.
void scan_values(Shared* shared, Threads* threads, int blocks, int* values, int count);

// Returns the first item of a part when count items are split evenly into parts.
static inline int split(int count, int part, int parts) { return (int)((int64_t)count * part / parts); }

#endif
