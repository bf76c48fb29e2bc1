// SPDX-License-Identifier: MIT
// fuzz_recording.c -- fuzz target: bytes are opened as a recording, which is repeated if it is accepted.
//
// The digests of the records are corrected first, because no mutation would ever hit them; an input with another header is
// opened as it is. Memory while a recording is opened is limited to LEAST_MEMORY + MEMORY_PER_BYTE times its size
// (docs/manual/security.md).
#include "fuzz/fuzz.h"
#include "fuzz/mutate_recording.h"
#include <stdlib.h>
#include <string.h>

#define LEAST_MEMORY    ((size_t)4 << 20)   // bytes
#define MEMORY_PER_BYTE 256                 // the snapshot of the beginning may need most of it
#define MOST_MEMORY     ((size_t)256 << 20) // bytes, while the recording is repeated
#define MOST_BYTES      65536
#define MOST_STEPS      24

static void check_repeated(scree_status status)
{
	if (status != SCREE_ERROR_DIFFERENT)
		fuzz_check_status(status, "scree_replay_step");
}

// Repeats the recording once, and begins again for some steps.
static void repeat(scree_replay* replay, scree_world* world)
{
	bool stepped = true;
	for (int k = 0; stepped && k < MOST_STEPS; ++k)
		check_repeated(scree_replay_step(replay, world, &stepped));
	scree_status status = scree_replay_restore(replay, world);
	fuzz_check_status(status, "scree_replay_restore");
	if (status == SCREE_OK)
		check_repeated(scree_replay_step(replay, world, &stepped));
}

static void open_and_repeat(const uint8_t* bytes, size_t size)
{
	scree_replay* replay;
	scree_world* world = NULL;
	scree_replay_info info;
	const scree_world_def def = fuzz_world_def();
	fuzz_limit_memory(MOST_MEMORY);
	scree_status status = scree_replay_open(bytes, size, &replay);
	fuzz_check_status(status, "scree_replay_open");
	if (status == SCREE_OK)
	{
		fuzz_check_status(scree_replay_get_info(replay, &info), "scree_replay_get_info");
		FUZZ_CHECK(info.read <= size, "%zu bytes of %zu are read", info.read, size);
		status = scree_replay_create_world(replay, &def, &world);
		fuzz_check_status(status, "scree_replay_create_world");
	}
	FUZZ_CHECK(fuzz_memory_peak() <= LEAST_MEMORY + MEMORY_PER_BYTE * size,
	           "%zu bytes of memory for a recording of %zu bytes", fuzz_memory_peak(), size);
	if (world)
	{
		++fuzz_accepted;
		repeat(replay, world);
		fuzz_use_world(world, 1.0f / 60.0f, 4);
	}
	scree_world_destroy(world);
	scree_replay_close(replay);
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
	// memory of exactly this size, so that an access beyond it is found
	fuzz_limit_memory(MOST_MEMORY);
	uint8_t* room = malloc(MOST_BYTES);
	size_t sealed = room ? recording_seal(bytes, size, room, MOST_BYTES) : 0;
	size_t used = sealed > 0 ? sealed : size;
	uint8_t* copy = malloc(used > 0 ? used : 1);
	if (!room || !copy)
		abort();
	memcpy(copy, sealed > 0 ? room : bytes, used);
	open_and_repeat(copy, used);
	free(copy);
	free(room);
	FUZZ_CHECK(scree_memory() == 0, "%zu bytes of memory are not released", scree_memory());
	return 0;
}

FUZZ_MUTATOR(mutate_recording, 16)
