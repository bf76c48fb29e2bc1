// SPDX-License-Identifier: MIT
// run_files.c -- the files of scree run that contain the state of the world: snapshots and a recording.
#include "run_files.h"
#include "cli/common/file_bytes.h"
#include "cli/common/library_error.h"
#include <stdlib.h>

// The place of a character is in its scene player, not in the world.
static int check_characters(const Options* options, const ScenePlayer* player)
{
	if (player->scene->character_count == 0)
		return EXIT_GOOD;
	fprintf(stderr, "%s %s: --%s: the scene has characters, which a snapshot does not contain\n", program_name,
	        options->name, options->load ? "load" : "save");
	return EXIT_BAD;
}

static int load(const Options* options, ScenePlayer* player)
{
	FileBytes file;
	int code = file_read(options, options->load, &file);
	if (code != EXIT_GOOD)
		return code;
	scree_counters counters;
	code = report(scree_world_restore(player->world, file.bytes, file.size));
	free(file.bytes);
	if (code == EXIT_GOOD)
		code = report(scree_world_get_counters(player->world, &counters));
	if (code == EXIT_GOOD)
		player->steps = counters.steps;
	return code;
}

int run_files_begin(const Options* options, ScenePlayer* player)
{
	int code = options->load || options->save ? check_characters(options, player) : EXIT_GOOD;
	if (code == EXIT_GOOD && options->load)
		code = load(options, player);
	if (code != EXIT_GOOD || !options->record)
		return code;
	scree_record_def def = scree_record_def_default();
	def.path = options->record;
	def.hash_interval = options->hash_interval;
	return report(scree_world_record(player->world, &def));
}

int run_files_end(const Options* options, ScenePlayer* player, int code)
{
	if (code == EXIT_GOOD && options->record)
		code = report(scree_world_end_recording(player->world));
	if (code != EXIT_GOOD || !options->save)
		return code;
	const void* bytes;
	size_t size;
	code = report(scree_world_snapshot(player->world, &bytes, &size));
	return code == EXIT_GOOD ? file_write(options, options->save, bytes, size) : code;
}
