// SPDX-License-Identifier: MIT
// relayout.c -- lays out the constraints of a world whose slots the host has written, as a step lays out new ones.
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
