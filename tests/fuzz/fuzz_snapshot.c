// SPDX-License-Identifier: MIT
// fuzz_snapshot.c -- fuzz target: bytes are restored as a snapshot, and the world is used if they are accepted.
//
// The digest of the bytes is corrected first, because no mutation would ever hit it. Memory while a snapshot is restored
// is limited to LEAST_MEMORY + MEMORY_PER_BYTE times its size (docs/manual/security.md).
#include "fuzz/fuzz.h"
#include "fuzz/mutate_chunks.h"
#include "world/snapshot/chunks.h"
#include <stdlib.h>
#include <string.h>

#define LEAST_MEMORY    ((size_t)4 << 20) // bytes, with an empty world
#define MEMORY_PER_BYTE 256
#define MOST_MEMORY     ((size_t)256 << 20) // bytes, while the world is used

static void restore_and_use(const uint8_t* bytes, size_t size)
{
	scree_world* world;
	const scree_world_def def = fuzz_world_def();
	fuzz_limit_memory(MOST_MEMORY);
	scree_status status = scree_world_create_from(&def, bytes, size, &world);
	fuzz_check_status(status, "scree_world_create_from");
	FUZZ_CHECK(fuzz_memory_peak() <= LEAST_MEMORY + MEMORY_PER_BYTE * size,
	           "%zu bytes of memory for a snapshot of %zu bytes", fuzz_memory_peak(), size);
	if (status != SCREE_OK)
		return;
	++fuzz_accepted;
	fuzz_use_world(world, 1.0f / 60.0f, 4);
	scree_world_destroy(world);
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
	uint8_t* copy = malloc(size > 0 ? size : 1);
	if (!copy)
		abort();
	memcpy(copy, bytes, size);
	if (size >= sizeof(uint64_t))
	{
		uint64_t digest = chunks_digest(copy, size - sizeof digest);
		memcpy(copy + size - sizeof digest, &digest, sizeof digest);
	}
	restore_and_use(copy, size);
	free(copy);
	FUZZ_CHECK(scree_memory() == 0, "%zu bytes of memory are not released", scree_memory());
	return 0;
}

FUZZ_MUTATOR(mutate_chunks, 16)
