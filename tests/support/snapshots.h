// SPDX-License-Identifier: MIT
// snapshots.h -- takes snapshots for tests, changes their chunks, and checks that they are refused.
#ifndef SNAPSHOTS_H
#define SNAPSHOTS_H
#include "support/checks.h"
#include <stdlib.h>
#include <string.h>

typedef struct
{
	void* bytes;
	size_t size;
} Saved;

// Copies bytes. The caller frees the copy.
static inline Saved copy_of(const void* bytes, size_t size)
{
	Saved saved = {malloc(size), size};
	assert_non_null(saved.bytes);
	memcpy(saved.bytes, bytes, size);
	return saved;
}

// Copies a snapshot out of the memory of its world. The caller frees its bytes.
static inline Saved save(scree_world* world)
{
	const void* bytes;
	size_t size;
	OK(scree_world_snapshot(world, &bytes, &size));
	return copy_of(bytes, size);
}

// Checks that a snapshot of a world has the same bytes as an earlier one.
static inline void assert_snapshot(scree_world* world, Saved before)
{
	const void* bytes;
	size_t size;
	OK(scree_world_snapshot(world, &bytes, &size));
	assert_int_equal(size, before.size);
	assert_memory_equal(bytes, before.bytes, before.size);
}

// Copies a snapshot without the chunk `left_out` (null: with all), and adds the chunk `added` (null: none) with `count`
// values of `bytes` bytes.
Saved copy_chunks(Saved saved, const char* left_out, const char* added, int bytes, int count, const void* values);

// Checks that a snapshot is refused with a message that contains `words`, and changes no world.
void refuse_snapshot(scree_world* world, const void* bytes, size_t size, const char* words);

#endif
