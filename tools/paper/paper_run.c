// SPDX-License-Identifier: MIT
// paper_run.c -- scree_paper run prints a table of results; scree_paper hash prints the hash.
#include "cli/common/library_error.h"
#include "cli/common/outputs.h"
#include "cli/common/run_report.h"
#include "scene/load.h"
#include "tools/paper/paper_commands.h"
#include "tools/paper/paper_player.h"
#include <inttypes.h>
#include <stdlib.h>

typedef struct
{
	PaperPlayer paper;
	Outputs outputs;
	Totals totals;
	scree_pose* poses; // poses of the pipeline's bodies, for pictures
	int body_count;
} Run;

static int allocate_poses(Run* run)
{
	int code = report(scree_world_get_bodies(run->paper.player.world, NULL, 0, &run->body_count));
	run->poses = malloc(((size_t)run->body_count + 1) * sizeof *run->poses);
	if (run->poses || code != EXIT_GOOD)
		return code;
	fprintf(stderr, "%s: out of memory for %d bodies\n", program_name, run->body_count);
	return EXIT_FAILED;
}

// Reads hash and poses of the current state.
static int read_snapshot(Run* run, Snapshot* snapshot)
{
	*snapshot = (Snapshot){&run->totals.last.counters, paper_hash(run->paper.paper), run->poses};
	// without pictures no poses are needed
	if (!run->outputs.renderer)
		return EXIT_GOOD;
	return report(paper_poses(run->paper.paper, run->poses, run->body_count));
}

static int draw_frames(Run* run)
{
	Snapshot snapshot;
	if (outputs_due(&run->outputs, &run->paper.player) == 0)
		return EXIT_GOOD;
	int code = read_snapshot(run, &snapshot);
	return code == EXIT_GOOD ? outputs_frames(&run->outputs, &run->paper.player, &snapshot) : code;
}

static int take_steps(Run* run, int steps)
{
	ProgressBar bar = progress_bar();
	int code = EXIT_GOOD;
	for (int step = 1; step <= steps && code == EXIT_GOOD; ++step)
	{
		Record record;
		code = report(paper_record_step(&run->paper, &record));
		if (code != EXIT_GOOD)
			break;
		totals_add(&run->totals, &record);
		code = outputs_step(&run->outputs, &run->paper.player, &record);
		if (code == EXIT_GOOD)
			code = draw_frames(run);
		if (code == EXIT_GOOD)
			progress_show(&bar, step, steps);
	}
	return code;
}

static int run_opened(Run* run, int steps)
{
	Snapshot snapshot;
	const ScenePlayer* player = &run->paper.player;
	int code = allocate_poses(run);
	if (code == EXIT_GOOD)
		code = outputs_open(&run->outputs, player, paper_stages);
	if (code == EXIT_GOOD)
		code = take_steps(run, steps);
	if (code == EXIT_GOOD)
		code = read_snapshot(run, &snapshot);
	code = outputs_close(&run->outputs, player, &snapshot, code);
	if (code == EXIT_GOOD)
		print_results(player, &run->totals, paper_stages, steps, snapshot.hash);
	free(run->poses);
	return code;
}

int paper_run_command(const Options* options)
{
	Scene* scene = open_scene(options, options->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	Run run = {0};
	Options drawn;
	int code = outputs_begin(&run.outputs, options, &drawn);
	if (code == EXIT_GOOD)
		code = paper_player_open(&drawn, scene, &run.paper);
	if (code != EXIT_GOOD)
		outputs_close(&run.outputs, NULL, NULL, code);
	else
	{
		code = run_opened(&run, options_steps(options, scene));
		paper_player_close(&run.paper);
	}
	scene_free(scene);
	return code;
}

int paper_hash_command(const Options* options)
{
	Scene* scene = open_scene(options, options->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	PaperPlayer paper;
	int code = paper_player_open(options, scene, &paper);
	if (code == EXIT_GOOD)
	{
		scree_status status = SCREE_OK;
		int steps = options_steps(options, scene);
		for (int step = 0; step < steps && status == SCREE_OK; ++step)
			status = paper_step(paper.paper, scene->dt);
		code = report(status);
		if (code == EXIT_GOOD)
			printf("%016" PRIx64 "\n", paper_hash(paper.paper));
		paper_player_close(&paper);
	}
	scene_free(scene);
	return code;
}
