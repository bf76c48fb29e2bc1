// SPDX-License-Identifier: MIT
// primitives.h -- sorts keys and computes prefix sums, as jobs whose blocks are shares of the items.
#ifndef PRIMITIVES_H
#define PRIMITIVES_H
#include "platform/threads.h"
#include <stdint.h>

#define RADIX_BITS 8
#define RADIX      (1 << RADIX_BITS)

typedef struct // data that the blocks of a sort or a scan share
{
	_Alignas(64) int counts[MAX_WORKERS][RADIX]; // number of keys with each digit, per block
	int sums[MAX_WORKERS];
	uint64_t *from, *to, mask;
	int *values, count, shift;
	bool moves; // the digits of the keys are not all equal, so the keys move
} Shared;

// Sorts `count` keys stably by bits low to high - 1. blocks: at most one per worker. other: memory for `count` keys.
void sort_keys(Shared* shared, Threads* threads, int blocks, uint64_t* keys, uint64_t* other, int count, int low,
               int high);

// Replaces each of the first `count` values by the sum of the values before it.
void scan_values(Shared* shared, Threads* threads, int blocks, int* values, int count);

#endif
