// SPDX-License-Identifier: MIT
// run_files.c -- the files of scree run that contain the state of the world: snapshots, a scene and a recording.
#include "run_files.h"
#include "cli/common/file_bytes.h"
#include "cli/common/library_error.h"
#include "scene/player_file.h"
#include "scene/write_scene.h"
#include <stdio.h>
#include <stdlib.h>

static int load(const Options* options, ScenePlayer* player)
{
	FileBytes file;
	int code = file_read(options, options->load, &file);
	if (code != EXIT_GOOD)
		return code;
	code = report_file(options->load, player_load(player, file.bytes, file.size, NULL, 0));
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

static int save(const Options* options, const ScenePlayer* player)
{
	const void* bytes;
	size_t size;
	int code = report(player_save(player, NULL, 0, &bytes, &size));
	return code == EXIT_GOOD ? file_write(options, options->save, bytes, size) : code;
}

// Writes the world as a scene file, with the name of that file.
static int write_scene(const Options* options, const ScenePlayer* player)
{
	char sentence[SCENE_SENTENCE];
	Scene named = *player->scene;
	named.name[0] = 0;
	scree_status status = scene_write_file(&named, player->world, options->write_scene, sentence);
	if (status == SCREE_OK || !*sentence)
		return report(status);
	fprintf(stderr, "%s %s: %s\n", program_name, options->name, sentence);
	return EXIT_FAILED;
}

int run_files_end(const Options* options, ScenePlayer* player, int code)
{
	if (code == EXIT_GOOD && options->record)
		code = report(scree_world_end_recording(player->world));
	if (code == EXIT_GOOD && options->save)
		code = save(options, player);
	return code == EXIT_GOOD && options->write_scene ? write_scene(options, player) : code;
}
