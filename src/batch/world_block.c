// SPDX-License-Identifier: MIT
// world_block.c -- steps the worlds of a batch that share pools: all of them on a GPU, some of them for a worker of a CPU.
#include "batch/world_block.h"
#include "batch/block_channels.h"
#include "batch/block_pools.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include <string.h>

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

static scree_status add_kinematics(Block* block)
{
	int count = 0;
	for (int k = 0; k < block->worlds; ++k)
		count += block->templates[block->template_of[block->first + k]].request.kinematic;
	block->request.kinematic = count;
	block->kinematics = scree_allocate(sizeof(int) * (size_t)(KINEMATIC_FEW + 1));
	if (!block->kinematics)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a batch");
	block->request.kinematics = block->kinematics;
	for (int k = 0, n = 0; k < block->worlds && count <= KINEMATIC_FEW; ++k)
	{
		const Template* from = block->templates + block->template_of[block->first + k];
		for (int i = 0; i < from->request.kinematic; ++i)
			block->kinematics[n++] = k * block->pipeline.bays.bodies + from->kinematics[i];
	}
	return SCREE_OK;
}

scree_status block_open(Block* block, Backend* backend, const Template* templates, int count, const int* template_of,
                        int first, int worlds)
{
	*block = (Block){
	    .backend = backend, .templates = templates, .template_of = template_of, .first = first, .worlds = worlds};
	block->spare_of = scree_allocate(sizeof(int) * (size_t)count);
	block->copies = scree_allocate(sizeof(Int2) * (size_t)worlds);
	if (!block->spare_of || !block->copies)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a batch");
	BaySizes sizes = {.worlds = worlds, .bodies = 1, .collidables = 1, .contacts = 1, .joints = 1};
	memset(block->spare_of, -1, sizeof(int) * (size_t)count);
	for (int k = 0; k < worlds; ++k)
	{
		int t = template_of[first + k];
		const Template* from = templates + t;
		if (block->spare_of[t] < 0)
			block->spare_of[t] = worlds + sizes.spares++;
		sizes.bodies = larger(sizes.bodies, from->bodies);
		sizes.collidables = larger(sizes.collidables, from->collidables);
		sizes.contacts = larger(sizes.contacts, from->contacts);
		sizes.joints = larger(sizes.joints, from->joints);
	}
	Pipeline* p = &block->pipeline;
	TRY(pipeline_open(p, backend, 0, 0));
	p->step = templates[template_of[first]].pipeline.step;
	block->request = templates[template_of[first]].request;
	for (int t = 0; t < count; ++t)
	{
		if (block->spare_of[t] < 0)
			continue;
		add_flags(p, &templates[t].pipeline);
		block->request.details |= templates[t].request.details;
		block->request.reports |= templates[t].request.reports;
	}
	TRY(bays_open(p, &sizes));
	block->request.bodies = worlds * sizes.bodies;
	block->request.collidables = worlds * sizes.collidables;
	block->request.contact_limit = 0;
	TRY(add_kinematics(block));
	TRY(block_fill(block, count));
	return block_reset(block, NULL);
}

void block_close(Block* block)
{
	pipeline_close(&block->pipeline);
	if (block->backend)
		block->backend->f->close(block->backend);
	scree_release(block->kinematics);
	scree_release(block->spare_of);
	scree_release(block->copies);
	scree_release(block->rows);
	*block = (Block){.first = 0};
}

scree_status block_reset(Block* block, const uint8_t* mask)
{
	int count = 0;
	for (int k = 0; k < block->worlds; ++k)
	{
		int t = block->template_of[block->first + k];
		if (mask && !mask[block->first + k])
			continue;
		block->copies[count++] = make_int2(block->spare_of[t], k);
		// joints of the template that have not begun, or that have broken since, change the pairs that never touch
		const Pipeline* from = &block->templates[t].pipeline;
		block->pipeline.dirty |= from->dirty || from->can_break;
		block->pipeline.surfaces_changed |= from->surfaces_changed;
		block->pipeline.taut |= from->taut;
		block->pipeline.counters.presses |= from->counters.presses; // Step.presses, in the next step
	}
	TRY(bays_copy(&block->pipeline, block->copies, count));
	return block_apply_reset(block, count);
}

scree_status block_step(Block* block, float dt, int substeps, int steps)
{
	block->request.dt = dt;
	block->request.substeps = substeps;
	if (steps == 0)
		return SCREE_OK;
	TRY(block_apply_inputs(block));
	for (int k = 0; k < steps; ++k)
	{
		if (k > 0)
			TRY(block_apply_again(block));
		TRY(pipeline_step(&block->pipeline, &block->request));
	}
	return block_write_outputs(block);
}

scree_status block_hash(Block* block, uint64_t* hashes)
{
	TRY(bays_hash(&block->pipeline, hashes + block->first));
	for (int k = block->first; k < block->first + block->worlds; ++k)
		hashes[k] += block->templates[block->template_of[k]].hidden;
	return SCREE_OK;
}
