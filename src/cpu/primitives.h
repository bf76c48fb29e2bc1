// SPDX-License-Identifier: MIT
// primitives.h -- sort and scan, by all workers together or by one alone.
#ifndef PRIMITIVES_H
#define PRIMITIVES_H
#include "platform/threads.h"
#include <stdint.h>

#define RADIX_BITS 8
#define RADIX      (1 << RADIX_BITS)

// Data shared between the workers.
typedef struct
{
	_Alignas(64) int counts[MAX_WORKERS][RADIX]; // of each worker: its keys of each digit
	int sums[MAX_WORKERS];
} Shared;

// Each is called by every worker of threads with equal arguments, or by one alone as worker 0 of 1. When a call returns,
// other workers may not have finished.

// Sorts keys[0] to keys[count - 1] by their bits from low up to, not including, high; stable. other is scratch.
void sort_keys(Shared* shared, Threads* threads, int worker, int workers, uint64_t* keys, uint64_t* other, int count,
               int low, int high);

// Replaces each of count values by the sum of the values before it.
void scan_values(Shared* shared, Threads* threads, int worker, int workers, int* values, int count);

// The first item of a part when count items are split evenly into parts.
static inline int split(int count, int part, int parts) { return (int)((int64_t)count * part / parts); }

#endif
