// SPDX-License-Identifier: MIT
// snapshots.h -- takes snapshots for tests.
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

#endif
