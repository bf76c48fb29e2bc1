// SPDX-License-Identifier: MIT
// relayout.c -- lays out constraints between steps, as a step does: of a world whose slots the host has written, or of the
// worlds of a batch.
#include "step/relayout.h"
#include "constraints/constraint_kinds.h"
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
	step_bays(&step, &pipeline->bays);
	step_places(&step, pipeline->backend);
	return step;
}

// Lays out all constraints of live items once. c: the counters on the host, as they are on the device afterwards.
static scree_status run_layout(Pipeline* pipeline, int bodies, Counters* c)
{
	Backend* b = pipeline->backend;
	memset(c->uncolored, 0, sizeof c->uncolored);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		c->dirty[kind] = 1;
	c->changed = 1;
	TRY(b->f->write(b, POOL_counters, 0, 1, c));
	Step step = constants(pipeline);
	list_layout(pipeline, bodies, 0);
	TRY(pipeline_run(pipeline, &step));
	return b->f->read(b, POOL_counters, 0, 1, c);
}

// Lays them out until there are places for all. entered: Counters.entered.
static scree_status lay_out(Pipeline* pipeline, int bodies, Counters* c, int entered)
{
	const int hubs = c->hubs;
	TRY(runs_reserve(&pipeline->list, STAGE_RUNS_MOST));
	for (;;)
	{
		c->entered = entered;
		c->hubs = hubs;
		TRY(run_layout(pipeline, bodies, c));
		if (c->arranged)
			return SCREE_OK;
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind) // spokes may need more places than there are
			TRY(pipeline_reserve(pipeline, kind_info[kind].places, c->layout[kind].begin[COLORS + 1]));
	}
}

scree_status pipeline_lay_out(Pipeline* pipeline, int bodies, bool spokes)
{
	Counters* c = &pipeline->counters;
	memset(c->layout, 0, sizeof c->layout);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		TRY(pipeline_reserve(pipeline, kind_info[kind].items, kind_items(c, kind) + 1));
	c->hubs = spokes;
	return lay_out(pipeline, bodies, c, spokes);
}

scree_status pipeline_lay_out_bays(Pipeline* pipeline)
{
	Backend* b = pipeline->backend;
	const Bays* bays = &pipeline->bays;
	Counters now, *host = &pipeline->counters;
	TRY(b->f->read(b, POOL_counters, 0, 1, &now)); // copies have changed counters that the host has not read
	now.stalled = 0;                               // an abandoned step is over
	host->hubs |= now.copied_spokes || layout_has_spokes(&now);
	// worlds may have come to bays that will be live
	const int contacts = host->contacts, joints = host->joints;
	host->contacts = now.contacts = bays->worlds << bays->contact_bits;
	host->joints = now.joints = pipeline->bay_joints > 0 ? bays->worlds << bays->joint_bits : 0;
	scree_status status = lay_out(pipeline, bays->worlds * bays->bodies, &now, 0);
	host->contacts = now.contacts = contacts;
	host->joints = now.joints = joints;
	TRY(status);
	memcpy(host->layout, now.layout, sizeof now.layout);
	host->hubs = now.hubs;
	pipeline->split = false;
	memset(pipeline->placed, 0, sizeof pipeline->placed);
	return b->f->write(b, POOL_counters, 0, 1, &now);
}
