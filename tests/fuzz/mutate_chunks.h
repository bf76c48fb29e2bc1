// SPDX-License-Identifier: MIT
// mutate_chunks.h -- changes a file of chunks (docs/design/snapshots.md) at random, and keeps it a file of chunks.
#ifndef MUTATE_CHUNKS_H
#define MUTATE_CHUNKS_H
#include <stddef.h>
#include <stdint.h>

// Changes `size` bytes in place, to at most `most` bytes, and returns the new size: a value, the number of values of a
// column or of all columns of equal length with the counters of that number, a chunk that is left out or repeated. Returns
// 0 if the bytes are no chunks.
size_t mutate_chunks(uint8_t* bytes, size_t size, size_t most, uint64_t seed);

// Returns a word near `old`, or one at a limit of numbers, counts or floats.
uint32_t mutate_word(uint32_t old, uint64_t* seed);

#endif
