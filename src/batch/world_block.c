// SPDX-License-Identifier: MIT
// world_block.c -- steps the worlds of a batch that share pools: all of them on a GPU, some of them for a worker of a CPU.
#include "batch/world_block.h"
#include "batch/block_channels.h"
#include "batch/block_gravity.h"
#include "batch/block_own.h"
#include "batch/block_places.h"
#include "batch/block_pools.h"
#include "batch/block_targets.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include "step/constants.h"
#include <string.h>

// Number of worlds of a block for each bay through which states come and go, and the maximum number of these bays. A GPU copies
// many worlds at once; on a CPU few of them stay in the cache.
#define STAGE_SHARE     8
#define STAGE_SHARE_CPU 32
#define STAGES_MOST     256

static int larger(int a, int b) { return a > b ? a : b; }

// Adds what a template needs to the flags of a block. The flags that only some worlds need change no bit of the others.
static void add_flags(Pipeline* p, const Pipeline* from)
{
	p->has_rolling |= from->has_rolling;
	p->heavy |= from->heavy;
	p->belts |= from->belts;
	p->segments |= from->segments;
	p->statics |= from->statics;
	p->bounces |= from->bounces;
	p->round |= from->round;
	p->has_drives |= from->has_drives;
	p->springs |= from->springs;
	p->couplings |= from->couplings;
	p->paths |= from->paths;
	p->unlocked |= from->unlocked;
	p->tethers |= from->tethers;
	p->can_break |= from->can_break;
	p->rules |= from->rules;
	p->platforms |= from->platforms;
	p->reports |= from->reports;
	p->material_pairs = larger(p->material_pairs, from->material_pairs);
	p->continuous_way = from->continuous_way < p->continuous_way ? from->continuous_way : p->continuous_way;
	p->continuous_reach = from->continuous_reach > p->continuous_reach ? from->continuous_reach : p->continuous_reach;
}

// Opens the pipeline with room for all bays, so that its pools need not grow at once.
static scree_status open_pools(Pipeline* p, Backend* backend, const BaySizes* sizes)
{
	int64_t bays = (int64_t)sizes->worlds + sizes->spares, contacts = 1;
	while (contacts < sizes->contacts)
		contacts *= 2;
	int64_t bodies = bays * larger(sizes->bodies, sizes->collidables) + GROUP_ITEMS;
	contacts = bays * contacts + GROUP_ITEMS;
	p->bays.worlds = sizes->worlds;
	bool fits = bodies <= MAX_ITEMS / 2 && contacts <= MAX_CONTACTS / 2; // else bays_open fails
	return pipeline_open(p, backend, fits ? (int)bodies : 0, fits ? (int)contacts : 0);
}

scree_status block_open(Block* block, Backend* backend, const Template* templates, int count, int* template_of,
                        const int* next_of, const WorldOrder* order, int first, int worlds, int contact_limit)
{
	*block = (Block){.backend = backend,
	                 .templates = templates,
	                 .template_of = template_of,
	                 .next_of = next_of,
	                 .order = order,
	                 .first = first,
	                 .worlds = worlds};
	block->template_count = count;
	block->spare_of = scree_allocate(sizeof(int) * (size_t)count);
	block->kinematics = scree_allocate(sizeof(int) * (size_t)(KINEMATIC_FEW + 1));
	if (!block->spare_of || !block->kinematics)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a batch");
	TRY(block_places_open(block));
	BaySizes sizes = {
	    .worlds = worlds, .bodies = 1, .collidables = 1, .contacts = 1, .joints = 1, .contact_limit = contact_limit};
	memset(block->spare_of, -1, sizeof(int) * (size_t)count);
	for (int k = 0; k < worlds; ++k)
		if (block->spare_of[block_number(block, k)] < 0)
			block->spare_of[block_number(block, k)] = worlds + sizes.spares++;
	for (int t = 0; t < count; ++t)
	{
		const Template* from = templates + t;
		if (next_of && block->spare_of[t] < 0 && template_fits(block_template(block, 0), from))
			block->spare_of[t] = worlds + sizes.spares++;
		if (block->spare_of[t] < 0)
			continue;
		sizes.bodies = larger(sizes.bodies, from->bodies);
		sizes.collidables = larger(sizes.collidables, from->collidables);
		sizes.contacts = larger(sizes.contacts, from->contacts);
		sizes.joints = larger(sizes.joints, from->joints);
		sizes.touching = larger(sizes.touching, from->touching);
		sizes.sensors = larger(sizes.sensors, from->visits.count);
	}
	TRY(block_targets_open(block));
	block->stage = worlds + sizes.spares;
	int stages = worlds / (backend->distant ? STAGE_SHARE : STAGE_SHARE_CPU);
	block->stages = stages < 1 ? 1 : stages < STAGES_MOST ? stages : STAGES_MOST;
	sizes.spares += block->stages;
	block->empty = worlds + sizes.spares++;
	Pipeline* p = &block->pipeline;
	TRY(open_pools(p, backend, &sizes));
	p->step = block_template(block, 0)->pipeline.step;
	block->request = block_template(block, 0)->request;
	for (int t = 0; t < count; ++t)
	{
		if (block->spare_of[t] < 0)
			continue;
		add_flags(p, &templates[t].pipeline);
		p->bay_joints = larger(p->bay_joints, templates[t].joints);
		block->restarts |= templates[t].restarts;
		block->request.details |= templates[t].request.details;
		block->request.reports |= templates[t].request.reports;
		block->request.sleep |= templates[t].request.sleep;
	}
	p->sleeps = block->request.sleep;
	TRY(bays_open(p, &sizes));
	block->touching = sizes.touching;
	block->request.contact_limit = 0;
	block->request.kinematics = block->kinematics;
	block_gravity_changes(block, 0, worlds);
	TRY(block_fill(block));
	return block_reset(block, NULL);
}

void block_close(Block* block)
{
	pipeline_close(&block->pipeline);
	if (block->backend)
		block->backend->f->close(block->backend);
	scree_release(block->kinematics);
	scree_release(block->spare_of);
	block_places_close(block);
	block_targets_close(block);
	scree_release(block->converted);
	scree_release(block->gravity_rows);
	block_own_close(block);
	*block = (Block){.first = 0};
}

// Gives the worlds of the first rows of the block the own values of their templates.
static scree_status restore_own(Block* block, int count)
{
	for (int k = 0; k < count && (block->own || block->restarts); ++k)
		TRY(block_own_take(block, block->rows[k], NULL));
	return block_own_send(block);
}

// Gives worlds that are reset their next templates. Returns whether some template is another one.
static bool change_templates(Block* block, const uint8_t* mask)
{
	bool changed = false;
	for (int row = 0; block->next_of && row < block->worlds; ++row)
	{
		int world = block_world(block, row);
		if (block->template_of[world] == block->next_of[world] || (mask && !mask[world]))
			continue;
		block->template_of[world] = block->next_of[world];
		block_gravity_changes(block, row, row + 1);
		changed = true;
	}
	return changed;
}

// Lists again what depends on the templates of the live bays.
static scree_status list_again(Block* block)
{
	TRY(block_count(block, block->pipeline.live_bays));
	block->pipeline.counters.changed = 1; // the next step may need another layout
	block->pipeline.dirty = true;
	return SCREE_OK;
}

scree_status block_reset(Block* block, const uint8_t* mask)
{
	int count = 0;
	bool changed = change_templates(block, mask);
	if (block->pipeline.live_bays == block->worlds)
	{
		TRY(block_restore(block, mask, &count));
		TRY(restore_own(block, count));
		if (changed)
			TRY(list_again(block));
		TRY(block_wake(block, block->rows, NULL, count));
		return block_apply_reset(block, count);
	}
	for (int k = 0; k < block->worlds; ++k)
		block->plan[k] = !mask || mask[block_world(block, k)] ? PLAN_RESET : block_runs(block, k) ? 0 : PLAN_PAUSE;
	TRY(block_arrange(block));
	for (int k = 0; k < block->worlds; ++k)
	{
		if (!(block->plan[k] & PLAN_RESET))
			continue;
		block_add_copy(block, &count, block->spare_of[block_number(block, k)], block->bay_of[k], k);
	}
	TRY(restore_own(block, count));
	if (changed)
		TRY(list_again(block));
	TRY(block_wake(block, block->rows, NULL, count));
	return block_apply_reset(block, count);
}

scree_status block_pause(Block* block, const uint8_t* mask)
{
	for (int k = 0; k < block->worlds; ++k)
		block->plan[k] = mask && mask[block_world(block, k)] ? PLAN_PAUSE : 0;
	return block_arrange(block);
}

// Finds the visits to sensors at the end of the last step, if they were not found yet.
static scree_status find_visits(Block* block)
{
	if (!block->visits_due)
		return SCREE_OK;
	block->visits_due = false;
	return bays_visit(&block->pipeline);
}

// Pauses the worlds whose contacts were too many for a step, which was abandoned.
static scree_status pause_crowded(Block* block)
{
	Backend* b = block->backend;
	int live = block->pipeline.live_bays, found = 0;
	TRY(find_visits(block));
	BayState* states = scree_allocate(sizeof *states * (size_t)live);
	if (!states)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to find the crowded ones of %d worlds", live);
	scree_status status = b->f->read(b, POOL_bay_state, 0, live, states);
	for (int k = 0; k < block->worlds; ++k)
	{
		bool runs = block_runs(block, k), crowded = runs && states[block->bay_of[k]].crowded > 0;
		block->plan[k] = !runs || crowded ? PLAN_PAUSE : 0;
		if (crowded && block->crowded + found++ == 0)
			block->first_crowded = k;
	}
	scree_release(states);
	TRY(status);
	ASSERT(found > 0);
	block->crowded += found;
	return block_arrange(block);
}

// first: true for the first step of a call, in which targets of the inputs act.
static scree_status step_once(Block* block, bool first)
{
	Pipeline* p = &block->pipeline;
	int presses = p->counters.presses;
	while (p->live_bays > 0)
	{
		block_aim(block, first);
		TRY(block_targets_request(block));
		scree_status status = pipeline_step(p, &block->request);
		block->visits_due |= status == SCREE_OK;
		if (status == SCREE_OK)
			block_targets_end(block);
		if (status == SCREE_OK || !p->crowded)
			return status;
		p->counters.presses = presses; // an abandoned step has not counted them
		TRY(pause_crowded(block));
	}
	if (block->request.dt > 0.0f)
	{
		p->step = step_constants(p, &block->request); // the next step compares its substeps with those of this one
		p->lengths_vary = false;
	}
	return SCREE_OK;
}

scree_status block_step(Block* block, float dt, int substeps, int steps)
{
	block->request.dt = dt;
	block->request.substeps = substeps;
	block->crowded = 0;
	if (steps == 0)
		return SCREE_OK;
	TRY(block_set_parameters(block));
	TRY(block_gravity(block));
	TRY(block_apply_inputs(block));
	TRY(block_own_search(block));
	TRY(block_refresh_chains(block));
	block_targets_replace(block);
	for (int k = 0; k < steps; ++k)
	{
		if (k > 0)
			TRY(block_apply_again(block));
		TRY(step_once(block, k == 0));
	}
	TRY(find_visits(block));
	return block_write_outputs(block);
}

scree_status block_hash(Block* block, uint64_t* hashes)
{
	uint64_t* device =
	    block->order->world ? scree_allocate(sizeof *device * (size_t)block->worlds) : hashes + block->first;
	if (!device)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the hashes of %d worlds", block->worlds);
	scree_status status = bays_hash(&block->pipeline, device);
	for (int row = 0; row < block->worlds && status == SCREE_OK; ++row)
	{
		const Template* from = block_template(block, row);
		hashes[block_world(block, row)] = device[row] + from->hidden + block_own_hash(block, row) +
		                                  targets_hash(&from->targets, block_targets_of(block, row));
	}
	if (block->order->world)
		scree_release(device);
	return status;
}

scree_status block_counters(Block* block, BayCounters* counters)
{
	if (!block->order->world)
		return bays_counters(&block->pipeline, counters + block->first);
	BayCounters* own = scree_allocate(sizeof *own * (size_t)block->worlds);
	if (!own)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the counters of %d worlds", block->worlds);
	scree_status status = bays_counters(&block->pipeline, own);
	for (int row = 0; row < block->worlds && status == SCREE_OK; ++row)
		counters[block_world(block, row)] = own[row];
	scree_release(own);
	return status;
}
