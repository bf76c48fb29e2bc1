// SPDX-License-Identifier: MIT
// replay_command.c -- scree replay, which repeats a recording on a device, or on two devices side by side.
#include "cli/common/differences.h"
#include "cli/common/file_bytes.h"
#include "cli/common/library_error.h"
#include "commands.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

typedef struct // a world in which the recording is repeated
{
	scree_replay* replay;
	scree_world* world;
	bool differs; // true: some result or hash differs from that of the recording
} Side;

static int side_open(const Options* options, const FileBytes* file, const char* device, bool first, Side* side)
{
	scree_world_def def = scree_world_def_default();
	def.device = device;
	def.allow_unequal_bits = options->allow_unequal_bits;
	def.threads = first ? options->threads : 0;
	def.lanes = first ? options->lanes : 0;
	int code = report_file(options->arguments[0], scree_replay_open(file->bytes, file->size, &side->replay));
	return code == EXIT_GOOD ? report(scree_replay_create_world(side->replay, &def, &side->world)) : code;
}

static void side_close(Side* side)
{
	scree_world_destroy(side->world);
	scree_replay_close(side->replay);
}

// Repeats a step. Prints the first difference from the recording. Returns EXIT_FAILED only if the replay cannot go on.
static int side_step(Side* side, bool* stepped)
{
	scree_status status = scree_replay_step(side->replay, side->world, stepped);
	if (status != SCREE_ERROR_DIFFERENT)
		return report(status);
	if (!side->differs)
		fprintf(stderr, "%s: %s: %s\n", program_name, scree_world_get_device(side->world), scree_error());
	side->differs = true;
	return EXIT_GOOD;
}

static int64_t step_of_side(const Side* side)
{
	scree_replay_info info = {0};
	scree_replay_get_info(side->replay, &info);
	return info.step;
}

// Compares the worlds of both sides. Prints the differences, and returns EXIT_FAILED, if their hashes differ.
static int compare_sides(const Side sides[2])
{
	uint64_t hashes[2];
	const void* bytes[2];
	size_t sizes[2];
	int code = report(scree_world_get_hash(sides[0].world, hashes));
	if (code == EXIT_GOOD)
		code = report(scree_world_get_hash(sides[1].world, hashes + 1));
	if (code != EXIT_GOOD || hashes[0] == hashes[1])
		return code;
	printf("step %" PRId64 ": %s and %s differ: %016" PRIx64 " | %016" PRIx64 "\n", step_of_side(sides),
	       scree_world_get_device(sides[0].world), scree_world_get_device(sides[1].world), hashes[0], hashes[1]);
	for (int k = 0; k < 2 && code == EXIT_GOOD; ++k)
		code = report(scree_world_snapshot(sides[k].world, bytes + k, sizes + k));
	if (code == EXIT_GOOD)
		print_differences(bytes[0], sizes[0], bytes[1], sizes[1]);
	return EXIT_FAILED;
}

// Repeats all steps, up to the first difference of the two sides or, with one side, from the recording.
static int repeat(Side sides[2], int count)
{
	int code = EXIT_GOOD;
	for (bool stepped = true; stepped && code == EXIT_GOOD;)
	{
		for (int k = 0; k < count && code == EXIT_GOOD; ++k)
			code = side_step(sides + k, &stepped);
		if (count == 2 && code == EXIT_GOOD)
			code = compare_sides(sides);
		else if (sides[0].differs)
			code = EXIT_FAILED;
	}
	return code == EXIT_GOOD && (sides[0].differs || sides[1].differs) ? EXIT_FAILED : code;
}

static void print_replay(const Options* options, const FileBytes* file, const Side sides[2], int count)
{
	scree_replay_info info = {0};
	uint64_t hash = 0;
	scree_replay_get_info(sides[0].replay, &info);
	scree_world_get_hash(sides[0].world, &hash);
	printf("recording      %s\n", options->arguments[0]);
	printf("version        %s\n", info.version);
	if (!info.ended)
		printf("end            missing after %zu bytes\n", info.read);
	else if (info.read < file->size)
		printf("end            after %zu of %zu bytes; the rest is not read\n", info.read, file->size);
	printf("device         %s\n", scree_world_get_device(sides[0].world));
	if (count == 2)
		printf("against        %s\n", scree_world_get_device(sides[1].world));
	printf("calls          %" PRId64 "\n", info.calls);
	printf("steps          %" PRId64 "\n", info.step);
	printf("hashes         %" PRId64 ", all equal\n", info.hashes);
	printf("hash           %016" PRIx64 "\n", hash);
}

int replay_command(const Options* options)
{
	FileBytes file;
	Side sides[2] = {{0}};
	int count = options->against ? 2 : 1, code = file_read(options, options->arguments[0], &file);
	if (code != EXIT_GOOD)
		return code;
	for (int k = 0; k < count && code == EXIT_GOOD; ++k)
		code = side_open(options, &file, k == 0 ? options->device : options->against, k == 0, sides + k);
	if (code == EXIT_GOOD)
		code = repeat(sides, count);
	if (code == EXIT_GOOD)
		print_replay(options, &file, sides, count);
	side_close(sides);
	side_close(sides + 1);
	free(file.bytes);
	return code;
}
