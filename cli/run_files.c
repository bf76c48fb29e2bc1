// SPDX-License-Identifier: MIT
// run_files.c -- the files of scree run that contain the state of the world: snapshots and a recording.
#include "run_files.h"
#include "cli/common/file_bytes.h"
#include "cli/common/library_error.h"
#include "scene/player_file.h"
#include <stdlib.h>

static int load(const Options* options, ScenePlayer* player)
{
	FileBytes file;
	int code = file_read(options, options->load, &file);
	if (code != EXIT_GOOD)
		return code;
	code = report(player_load(player, file.bytes, file.size, NULL, 0));
	free(file.bytes);
	return code;
}

int run_files_begin(const Options* options, ScenePlayer* player)
{
	int code = options->load ? load(options, player) : EXIT_GOOD;
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
	code = report(player_save(player, NULL, 0, &bytes, &size));
	return code == EXIT_GOOD ? file_write(options, options->save, bytes, size) : code;
}
