// SPDX-License-Identifier: MIT
// relayout.c -- lays out constraints between steps, as a step does: of a world whose slots the host has written, or of the
// worlds of a batch.
#include "step/relayout.h"
#include "platform/error.h"
#include "step/constants.h"
#include "step/dispatch.h"
#include "step/reserve.h"
#include "step/stage_lists.h"
#include <string.h>

// Returns the constants of the last step, as far as the kernels of a layout read them.
static Step constants(const Pipeline* pipeline)
{
	Step step = pipeline->step;
	step.belts = pipeline->belts;
	step.joints = pipeline->counters.joints > 0;
	step.chain_places = pipeline->chain_places;
	step.sleep = 0;
	step_places(&step, pipeline->backend);
	return step;
}

static scree_status run_layout(Pipeline* pipeline, int bodies, bool spokes)
{
	Backend* b = pipeline->backend;
	Counters* c = &pipeline->counters;
	memset(c->uncolored, 0, sizeof c->uncolored);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		c->dirty[kind] = 1;
	c->changed = 1;
	c->entered = c->hubs = spokes;
	TRY(b->f->write(b, POOL_counters, 0, 1, c));
	Step step = constants(pipeline);
	list_layout(pipeline, bodies, 0);
	TRY(pipeline_run(pipeline, &step));
	return b->f->read(b, POOL_counters, 0, 1, c);
}

scree_status pipeline_lay_out(Pipeline* pipeline, int bodies, bool spokes)
{
	Counters* c = &pipeline->counters;
	TRY(runs_reserve(&pipeline->list, STAGE_RUNS_MOST));
	memset(c->layout, 0, sizeof c->layout);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		TRY(pipeline_reserve(pipeline, kind_info[kind].items, kind_items(c, kind) + 1));
	for (;;)
	{
		TRY(run_layout(pipeline, bodies, spokes));
		if (c->arranged)
			break;
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind) // spokes may need more places than there are
			TRY(pipeline_reserve(pipeline, kind_info[kind].places, c->layout[kind].begin[COLORS + 1]));
	}
	return SCREE_OK;
}

// Runs the layout of all worlds of a batch once. Reads the counters after it into *now.
static scree_status run_again(Pipeline* pipeline, Counters* now)
{
	Backend* b = pipeline->backend;
	int bodies = pipeline->live_bays * pipeline->bays.bodies;
	TRY(b->f->read(b, POOL_counters, 0, 1, now)); // copies have changed counters that the host has not read
	memset(now->uncolored, 0, sizeof now->uncolored);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		now->dirty[kind] = 1;
	now->changed = 1;
	now->entered = now->stalled = 0; // an abandoned step is over
	pipeline->counters.hubs |= now->copied_spokes || now->layout[CONSTRAINT_CONTACT].count[COLORS] > 0;
	TRY(b->f->write(b, POOL_counters, 0, 1, now));
	Step step = constants(pipeline);
	step_bays(&step, &pipeline->bays);
	list_layout(pipeline, bodies, 0);
	TRY(pipeline_run(pipeline, &step));
	return b->f->read(b, POOL_counters, 0, 1, now);
}

scree_status pipeline_lay_out_bays(Pipeline* pipeline)
{
	Counters now;
	TRY(runs_reserve(&pipeline->list, STAGE_RUNS_MOST));
	for (;;)
	{
		TRY(run_again(pipeline, &now));
		if (now.arranged)
			break;
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind) // spokes may need more places than there are
			TRY(pipeline_reserve(pipeline, kind_info[kind].places, now.layout[kind].begin[COLORS + 1]));
	}
	memcpy(pipeline->counters.layout, now.layout, sizeof now.layout);
	pipeline->counters.hubs = now.hubs;
	pipeline->split = false;
	pipeline->placed = 0;
	return SCREE_OK;
}
