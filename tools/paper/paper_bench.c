// SPDX-License-Identifier: MIT
// paper_bench.c -- scree_paper bench: measures the time of scenes with the paper's pipeline.
#include "cli/common/bench_scenes.h"
#include "cli/common/library_error.h"
#include "tools/paper/paper_commands.h"
#include "tools/paper/paper_player.h"

static int run_scene(const Options* options, bool timings, Measurement* m)
{
	PaperPlayer paper;
	int code = paper_player_open(options, m->scene, &paper);
	if (code != EXIT_GOOD)
		return code;
	scree_status status = SCREE_OK;
	for (int step = 0; step < m->steps && status == SCREE_OK; ++step)
	{
		Record record;
		status = paper_record_step(&paper, &record);
		if (status == SCREE_OK)
			measurement_add(m, &record, step);
	}
	if (status == SCREE_OK)
		measurement_end_run(m, paper.player.world, timings, paper_hash(paper.paper), 0);
	code = report(status);
	paper_player_close(&paper);
	return code;
}

int paper_bench_command(const Options* options)
{
	SceneList list;
	int code = open_scenes(options, &list);
	for (int k = 0; k < list.count && code == EXIT_GOOD; ++k)
		code = paper_takes(list.scenes[k]) ? EXIT_GOOD : EXIT_BAD;
	if (code == EXIT_GOOD)
		code = bench_scenes(options, &list, paper_stages, run_scene);
	close_scenes(&list);
	return code;
}
