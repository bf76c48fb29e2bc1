// SPDX-License-Identifier: MIT
// make_seeds.c -- writes snapshots or recordings of worlds that programs of calls have made, as seeds of fuzz targets.
#include "programs/run_call.h"
#include <stdlib.h>
#include <string.h>

#define CALLS 40 // number of calls of a random program
#define BEGIN 12 // number of its calls before a recording begins

static void stop(const char* what, const char* reason)
{
	fprintf(stderr, "make_seeds: %s: %s\n", what, reason);
	exit(1);
}

// Runs a program, and writes a snapshot of its world, or a recording of its last calls, to a file.
static void write_seed(const Program* program, bool records, const char* path)
{
	static struct Names names;
	static const Place place = {.device = "cpu", .threads = 1, .lanes = 1};
	scree_world* world;
	const void* bytes;
	size_t size;
	if (run_world(&place, &program->calls[0], &world) != SCREE_OK)
		stop(path, scree_error());
	for (int k = 1; k < program->count; ++k)
	{
		Left left = {0};
		const scree_record_def def = {.size = sizeof def, .hash_interval = 1};
		if (records && k == BEGIN && scree_world_record(world, &def) != SCREE_OK)
			stop(path, scree_error());
		run_call(&(CallRun){&program->calls[k], world, &names, &place, "cpu", &left});
	}
	if (records ? scree_world_end_recording(world) || scree_world_get_recording(world, &bytes, &size)
	            : scree_world_snapshot(world, &bytes, &size))
		stop(path, scree_error());
	FILE* file = fopen(path, "wb");
	if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
		stop(path, "cannot be written");
	printf("%s: %zu bytes\n", path, size);
	scree_world_destroy(world);
	names_clear(&names);
}

static void read_program(Program* program, const char* path)
{
	char error[256] = "cannot be opened";
	FILE* file = fopen(path, "r");
	if (!file || !program_read(program, file, error))
		stop(path, error);
	fclose(file);
}

int main(int count, char** arguments)
{
	Program program = {0};
	bool records = count > 1 && strcmp(arguments[1], "recording") == 0;
	if (count < 4 || !(records || strcmp(arguments[1], "snapshot") == 0))
	{
		fprintf(stderr, "usage: make_seeds (snapshot | recording) FOLDER (SEED | FILE)...\n"
		                "Writes a seed for each random program, by its number, and for each program in a file.\n");
		return 2;
	}
	pair_hide_log();
	for (int k = 3; k < count; ++k)
	{
		char path[1024], *end;
		uint64_t seed = strtoull(arguments[k], &end, 10);
		const char* slash = strrchr(arguments[k], '/');
		if (*end)
			read_program(&program, arguments[k]);
		else
			program_make(&program, seed, CALLS);
		snprintf(path, sizeof path, "%s/%s.bin", arguments[2], slash ? slash + 1 : arguments[k]);
		write_seed(&program, records, path);
	}
	program_close(&program);
	return 0;
}
