// SPDX-License-Identifier: MIT
// bench_command.c -- scree bench: measures scenes and checks that the work was done.
#include "bench_batch.h"
#include "bench_whole.h"
#include "cli/common/bench_scenes.h"
#include "cli/common/library_error.h"
#include "commands.h"

static int run_scene(const Options* options, bool timings, Measurement* m)
{
	ScenePlayer player;
	int code = open_player(options, m->scene, timings, &player);
	if (code != EXIT_GOOD)
		return code;
	uint64_t hash = 0;
	scree_status status = SCREE_OK;
	for (int step = 0; step < m->steps && status == SCREE_OK; ++step)
	{
		Record record;
		status = record_step(&player, &record);
		if (status == SCREE_OK)
			measurement_add(m, &record, step);
	}
	if (status == SCREE_OK)
		status = scree_world_get_hash(player.world, &hash);
	if (status == SCREE_OK && m->bandwidth == 0)
		status = scree_world_measure_bandwidth(player.world, &m->bandwidth);
	if (status == SCREE_OK)
		measurement_end_run(m, player.world, timings, hash, player.answered.hash);
	code = report(status);
	player_close(&player);
	return code;
}

int bench_command(const Options* options)
{
	SceneList list;
	int code = open_scenes(options, &list);
	if (code == EXIT_GOOD && options->whole)
		code = measure_whole_runs(options, list.scenes, list.count);
	else if (code == EXIT_GOOD && options->worlds > 0)
		code = measure_batches(options, &list);
	else if (code == EXIT_GOOD)
		code = bench_scenes(options, &list, stage_names, run_scene);
	close_scenes(&list);
	return code;
}
