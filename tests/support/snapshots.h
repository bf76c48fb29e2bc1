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

// Copies a snapshot out of the memory of its world. The caller frees its bytes.
static inline Saved save(scree_world* world)
{
	const void* bytes;
	Saved saved;
	OK(scree_world_snapshot(world, &bytes, &saved.size));
	saved.bytes = malloc(saved.size);
	assert_non_null(saved.bytes);
	memcpy(saved.bytes, bytes, saved.size);
	return saved;
}

// Copies a snapshot without the chunk `left_out` (null: with all), and adds the chunk `added` (null: none) with `count`
// values of `bytes` bytes.
Saved copy_chunks(Saved saved, const char* left_out, const char* added, int bytes, int count, const void* values);

// Checks that a snapshot is refused with a message that contains `words`, and changes no world.
void refuse_snapshot(scree_world* world, const void* bytes, size_t size, const char* words);

#endif
