// SPDX-License-Identifier: MIT
// run_worlds.c -- scree run --worlds: steps copies of a scene in a batch, and takes out one of them.
#include "run_worlds.h"
#include "batch_scene.h"
#include "cli/common/library_error.h"
#include "tools/common/clock.h"
#include <stdlib.h>
#include <string.h>

// Returns whether a list of layers has a layer that shows events, which the worlds of a batch do not note. If so, prints
// it.
static bool shows_events(const Options* options)
{
	static const char* const events[] = {"visits", "touches", "hits", "breaks"};
	for (const char* at = options->layers; at && *at; at += strcspn(at, ","), at += *at == ',')
		for (size_t k = 0; k < sizeof events / sizeof *events; ++k)
			if (strcspn(at, ",") == strlen(events[k]) && strncmp(at, events[k], strlen(events[k])) == 0)
			{
				fprintf(stderr, "%s %s: --layers %s shows events, which the worlds of a batch do not have\n",
				        program_name, options->name, events[k]);
				return true;
			}
	return false;
}

bool run_worlds_can(const Options* options, const Scene* scene)
{
	return batch_takes(options, scene) && !shows_events(options);
}

// Adds the counters of a step to the totals. Returns false and prints a sentence if the shown world was paused.
static bool add_step(const Options* options, const scree_batch_counters* shown, double seconds, Totals* totals)
{
	Record record = {.milliseconds = (float)(1000 * seconds)};
	record.counters.penetration = shown->penetration;
	record.counters.joint_gap = shown->joint_gap;
	record.counters.frozen_bodies = shown->frozen_bodies;
	totals_add(totals, &record);
	if (shown->crowded > 0)
		fprintf(stderr, "%s %s: world %d was paused: it needs %d contacts, more than a world of the batch may have\n",
		        program_name, options->name, options->show, shown->crowded);
	return shown->crowded == 0;
}

static int take_steps(const Options* options, scree_batch* batch, const ScenePlayer* player, int steps, Totals* totals)
{
	const Scene* scene = player->scene;
	ProgressBar bar = progress_bar();
	scree_batch_counters* counters = malloc((size_t)options->worlds * sizeof *counters);
	int code = counters ? EXIT_GOOD : EXIT_FAILED;
	if (!counters)
		fprintf(stderr, "%s %s: out of memory for %d worlds\n", program_name, options->name, options->worlds);
	for (int step = 1; step <= steps && code == EXIT_GOOD; ++step)
	{
		double begin = seconds_now();
		scree_status status = scree_batch_step(batch, scene->dt, scene->substeps, 1);
		// reading the counters waits for the device, so that the time includes all work of the step
		if (status == SCREE_OK)
			status = scree_batch_get_counters(batch, counters);
		code = report(status);
		if (code == EXIT_GOOD && !add_step(options, counters + options->show, seconds_now() - begin, totals))
			code = EXIT_FAILED;
		if (code == EXIT_GOOD)
			progress_show(&bar, step, steps);
	}
	free(counters);
	return code;
}

// Gives the world of the player the state of a world of the batch. The pictures keep their world, whose handles stay valid.
static scree_status take_out(scree_batch* batch, int world, ScenePlayer* player)
{
	scree_world* alone;
	const void* bytes;
	size_t size;
	scree_status status = scree_batch_extract(batch, world, NULL, &alone);
	if (status == SCREE_OK)
		status = scree_world_snapshot(alone, &bytes, &size);
	if (status == SCREE_OK)
		status = scree_world_restore(player->world, bytes, size);
	scree_world_destroy(alone);
	return status;
}

// Completes the counters of the last step by those of the world.
static scree_status complete(const ScenePlayer* player, Totals* totals)
{
	scree_counters last = totals->last.counters, *now = &totals->last.counters;
	scree_status status = scree_world_get_counters(player->world, now);
	now->penetration = last.penetration;
	now->joint_gap = last.joint_gap;
	now->frozen_bodies = last.frozen_bodies;
	return status;
}

int run_worlds(const Options* options, ScenePlayer* player, int steps, Totals* totals)
{
	scree_batch* batch;
	scree_batch_def def = batch_definition(options, &player->world);
	int code = report(scree_batch_create(&def, &batch));
	if (code == EXIT_GOOD)
		code = take_steps(options, batch, player, steps, totals);
	if (code == EXIT_GOOD)
	{
		player->steps += steps;
		code = report(take_out(batch, options->show, player));
	}
	scree_batch_destroy(batch);
	return code == EXIT_GOOD ? report(complete(player, totals)) : code;
}
