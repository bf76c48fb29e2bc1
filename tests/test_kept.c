// SPDX-License-Identifier: MIT
// test_kept.c -- checks that recordings and snapshots of released versions can still be read, and go on with the same bits.
//
// The files of tests/kept were written by the version in the name of their folder, and are never written again. Each is a
// recording that begins in the middle of a run: contacts with impulses, joints, rules, sleepers. If a later version changes
// bits on purpose, the hashes of older files differ: then `bits` of their row becomes false.
#include "support/recordings.h"
#include "support/second_device.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct
{
	const char* name; // in tests/kept
	bool bits;        // this version computes the same bits
} Kept;

static const Kept kept[] = {
    {"0.2.0/bridge.rec", true},
    {"0.2.0/platforms.rec", true},
    {"0.2.0/program-64.rec", true},
    {"0.2.0/program-1004.rec", true},
};

static Saved read_kept(const Kept* file)
{
	char path[1024];
	const char* source = getenv("SCREE_SOURCE");
	snprintf(path, sizeof path, "%s/tests/kept/%s", source ? source : ".", file->name);
	FILE* stream = fopen(path, "rb");
	if (!stream || fseek(stream, 0, SEEK_END) != 0)
		fail_msg("%s cannot be read", path);
	Saved saved = {NULL, (size_t)ftell(stream)};
	saved.bytes = malloc(saved.size);
	rewind(stream);
	assert_int_equal(fread(saved.bytes, 1, saved.size, stream), saved.size);
	fclose(stream);
	return saved;
}

// Repeats all kept files.
static void repeat_kept(const char* device, int threads, int lanes)
{
	for (size_t k = 0; k < sizeof kept / sizeof *kept; ++k)
	{
		Saved saved = read_kept(kept + k);
		const scree_world_def def = def_on(device, threads, lanes);
		scree_replay* replay;
		scree_world* world;
		OK(scree_replay_open(saved.bytes, saved.size, &replay));
		assert_true(info_of(replay).ended);
		OK(scree_replay_create_world(replay, &def, &world));
		for (bool stepped = true; stepped;)
		{
			scree_status status = scree_replay_step(replay, world, &stepped);
			if (status != SCREE_OK && (kept[k].bits || status != SCREE_ERROR_DIFFERENT))
				fail_msg("%s: %s", kept[k].name, scree_error());
		}
		scree_world_destroy(world);
		scree_replay_close(replay);
		free(saved.bytes);
	}
}

static void kept_files_are_repeated(void** state)
{
	(void)state;
	repeat_kept("cpu", 1, 0);
	repeat_kept("cpu", 2, 1);
}

static void kept_files_are_repeated_on_opencl(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	repeat_kept(second_device, 0, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(kept_files_are_repeated),
	    cmocka_unit_test(kept_files_are_repeated_on_opencl),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
