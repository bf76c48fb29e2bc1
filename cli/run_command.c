// SPDX-License-Identifier: MIT
// run_command.c -- scree run, which prints a table of results, and scree hash, which prints the hash, or the sum of the hashes of many worlds.
#include "batch_scene.h"
#include "cli/common/library_error.h"
#include "cli/common/open_scene.h"
#include "cli/common/outputs.h"
#include "cli/common/run_report.h"
#include "commands.h"
#include "hash_worlds.h"
#include "run_files.h"
#include "run_worlds.h"
#include "scene/load.h"
#include "tools/common/clock.h"
#include <inttypes.h>

static int draw_frames(ScenePlayer* player, Outputs* outputs, const Record* record)
{
	if (outputs_due(outputs, player) == 0)
		return EXIT_GOOD;
	Snapshot snapshot = {.counters = &record->counters};
	int code = report(scree_world_get_hash(player->world, &snapshot.hash));
	return code == EXIT_GOOD ? outputs_frames(outputs, player, &snapshot) : code;
}

static int take_steps(ScenePlayer* player, Outputs* outputs, int steps, Totals* totals)
{
	ProgressBar bar = progress_bar();
	int code = EXIT_GOOD;
	for (int step = 1; step <= steps && code == EXIT_GOOD; ++step)
	{
		Record record;
		code = report(record_step(player, &record));
		if (code != EXIT_GOOD)
			break;
		totals_add(totals, &record);
		code = outputs_step(outputs, player, &record);
		if (code == EXIT_GOOD)
			code = draw_frames(player, outputs, &record);
		if (code == EXIT_GOOD)
			progress_show(&bar, step, steps);
	}
	return code;
}

int run_command(const Options* given)
{
	Scene* scene = open_scene(given, given->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	bool many = given->worlds > 0;
	Options batched = many ? batch_options(given) : *given, *options = &batched;
	if (many && !run_worlds_can(options, scene))
	{
		scene_free(scene);
		return EXIT_BAD;
	}
	ScenePlayer player;
	Outputs outputs;
	Totals totals = {0};
	Snapshot snapshot = {.counters = &totals.last.counters};
	int steps = options_steps(options, scene);
	Options drawn;
	int code = outputs_begin(&outputs, options, &drawn);
	if (code == EXIT_GOOD)
		code = open_player(&drawn, scene, true, &player);
	if (code != EXIT_GOOD)
		outputs_close(&outputs, NULL, NULL, code);
	else
	{
		code = outputs_open(&outputs, &player, stage_names);
		if (code == EXIT_GOOD)
			code = run_files_begin(options, &player);
		if (code == EXIT_GOOD)
			code = many ? run_worlds(options, &player, steps, &totals) : take_steps(&player, &outputs, steps, &totals);
		if (code == EXIT_GOOD)
			code = report(scree_world_get_hash(player.world, &snapshot.hash));
		code = run_files_end(options, &player, code);
		code = outputs_close(&outputs, &player, &snapshot, code);
		if (code == EXIT_GOOD)
			print_results(&player, &totals, many ? NULL : stage_names, steps, snapshot.hash);
		if (code == EXIT_GOOD && many)
			printf("%-14s %d in the batch; these are the results of world %d\n", "worlds", options->worlds,
			       options->show);
		player_close(&player);
	}
	scene_free(scene);
	return code;
}

int hash_command(const Options* given)
{
	Scene* scene = open_scene(given, given->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	bool many = given->worlds > 0;
	Options batched = many ? batch_options(given) : *given, *options = &batched;
	if (many && !batch_takes(options, scene))
	{
		scene_free(scene);
		return EXIT_BAD;
	}
	ScenePlayer player;
	uint64_t hash = 0;
	int code = open_player(options, scene, false, &player);
	if (code == EXIT_GOOD && many)
	{
		code = hash_worlds(options, &player, &hash);
		player_close(&player);
	}
	else if (code == EXIT_GOOD)
	{
		scree_status status = SCREE_OK;
		int steps = options_steps(options, scene);
		for (int step = 0; step < steps && status == SCREE_OK; ++step)
			status = player_step(&player);
		if (status == SCREE_OK)
			status = scree_world_get_hash(player.world, &hash);
		code = report(status);
		player_close(&player);
	}
	if (code == EXIT_GOOD)
		printf("%016" PRIx64 "\n", hash);
	scene_free(scene);
	return code;
}
