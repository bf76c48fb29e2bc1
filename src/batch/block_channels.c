// SPDX-License-Identifier: MIT
// block_channels.c -- moves rows of inputs and outputs between the memory of the user and the pools of a block.
#include "batch/block_channels.h"
#include "batch/block_own.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include "step/reserve.h"
#include <string.h>

#define ALIGNED 64 // columns: rows of a list begin at a multiple of this

// Returns memory of the user for the rows of the block.
static float* memory_of(const Block* block, int which)
{
	const ChannelSet* set = block->sets + which;
	return set->memory + (size_t)block->first * (size_t)set->columns;
}

static scree_status run_groups(Block* block, int kernel, int which, int bits, int rows, int begin, int end)
{
	int first = begin * rows, items = end * rows;
	if (end <= begin || rows == 0)
		return SCREE_OK;
	return bays_run(&block->pipeline, kernel, first, items, RUN_PAIR(which | bits, rows));
}

// Computes the places of all lists. Returns the numbers of channels, of groups and of columns.
static void lay_out(Block* block, int templates, int* channels, int* groups, int64_t* columns)
{
	*channels = *groups = 0;
	*columns = 0;
	for (int k = 0; k < CHANNEL_LISTS; ++k)
	{
		const ChannelSet* set = block->sets + k;
		block->lists[k] = (ChannelList){.first = *channels,
		                                .channels = set->count,
		                                .groups = set->groups,
		                                .first_group = *groups,
		                                .columns = set->columns,
		                                .column = (int)*columns};
		*channels += templates * set->count;
		*groups += set->groups + 1;
		*columns += ((int64_t)block->worlds * set->columns + ALIGNED - 1) / ALIGNED * ALIGNED;
	}
}

static bool converts(const ChannelSet* set) { return set->poses || set->unit != 0.0; }

static scree_status reserve_rows(Block* block)
{
	int columns = block->sets[CHANNELS_RESET].columns;
	for (int k = 0; k < CHANNEL_LISTS; ++k)
		if (converts(block->sets + k) && block->sets[k].columns > columns)
			columns = block->sets[k].columns;
	scree_release(block->converted);
	block->converted = scree_allocate(sizeof(float) * ((size_t)block->worlds * (size_t)columns + 1));
	return block->converted ? SCREE_OK
	                        : fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for rows of %d worlds", block->worlds);
}

static scree_status write_list(Block* block, int which, int templates)
{
	Backend* b = block->backend;
	const ChannelSet* set = block->sets + which;
	const ChannelList* list = block->lists + which;
	int groups[1] = {0};
	if (set->count == 0)
		return b->f->write(b, POOL_channel_group, list->first_group, 1, groups);
	TRY(b->f->write(b, POOL_channel, list->first, templates * set->count, set->channels));
	TRY(b->f->write(b, POOL_channel_group, list->first_group, set->groups + 1, set->group));
	return b->f->clear(b, POOL_column, list->column, block->worlds * set->columns);
}

scree_status block_bind(Block* block, const ChannelSet* sets, int templates)
{
	Backend* b = block->backend;
	Pipeline* p = &block->pipeline;
	int channels, groups;
	int64_t columns;
	block->sets = sets;
	lay_out(block, templates, &channels, &groups, &columns);
	if (columns > INT32_MAX / 4)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%lld inputs and outputs of a batch are too many", (long long)columns);
	int most = channels > groups ? channels : groups;
	TRY(pipeline_reserve(p, PER_CHANNEL, most > CHANNEL_LISTS ? most : CHANNEL_LISTS));
	TRY(pipeline_reserve(p, PER_COLUMN, (int)columns + 1));
	TRY(reserve_rows(block));
	for (int k = 0; k < CHANNEL_LISTS; ++k)
		TRY(write_list(block, k, templates));
	TRY(b->f->write(b, POOL_channel_list, 0, CHANNEL_LISTS, block->lists));
	QueryPlan plan = {.shape = {.count = 1}}; // settings of rays: those of a query by default
	TRY(b->f->write(b, POOL_query_plan, 0, 1, &plan));
	const ChannelSet* outputs = sets + CHANNELS_OUTPUTS;
	return run_groups(block, KERNEL_channel_body, CHANNELS_OUTPUTS, CHANNEL_BEGINS, p->live_bays, 0,
	                  outputs->joint_group);
}

static scree_status apply(Block* block, int bits)
{
	const ChannelSet* set = block->sets + CHANNELS_STEP;
	return run_groups(block, KERNEL_channel_input, CHANNELS_STEP, bits, block->pipeline.live_bays, 0, set->groups);
}

// Applies the parameters of a world, whose row of inputs is `values`.
static scree_status set_parameters(Block* block, const ChannelSet* set, int row, const float* values)
{
	float metres[MOST_COLUMNS];
	if (set->unit == 0.0)
		return block_own_set(block, set, row, values);
	channels_put(set, metres, values);
	return block_own_set(block, set, row, metres);
}

scree_status block_set_parameters(Block* block)
{
	const ChannelSet* set = block->sets ? block->sets + CHANNELS_STEP : NULL;
	if (!set || set->parameters == 0)
		return SCREE_OK;
	const float* rows = memory_of(block, CHANNELS_STEP);
	for (int k = 0; k < block->worlds; ++k)
		if (block_runs(block, k))
			TRY(set_parameters(block, set, k, rows + (size_t)k * (size_t)set->columns));
	return block_own_send(block);
}

scree_status block_apply_inputs(Block* block)
{
	Backend* b = block->backend;
	if (!block->sets || block->sets[CHANNELS_STEP].count == 0)
		return SCREE_OK;
	const ChannelSet* set = block->sets + CHANNELS_STEP;
	const float* rows = memory_of(block, CHANNELS_STEP);
	size_t columns = (size_t)set->columns;
	for (int k = 0; k < block->worlds && converts(set); ++k)
		channels_put(set, block->converted + (size_t)k * columns, rows + (size_t)k * columns);
	TRY(b->f->write(b, POOL_column, block->lists[CHANNELS_STEP].column, block->worlds * set->columns,
	                converts(set) ? block->converted : rows));
	block->pipeline.edited |= set->places;
	return apply(block, 0);
}

scree_status block_apply_again(Block* block)
{
	return block->sets && block->sets[CHANNELS_STEP].acts ? apply(block, CHANNEL_AGAIN) : SCREE_OK;
}

void block_aim(Block* block, bool first)
{
	int live = block->pipeline.live_bays;
	bool aims = first && block->sets && block->sets[CHANNELS_STEP].aims;
	block->request.targets = aims ? block->sets[CHANNELS_STEP].joint_group * live : 0;
	block->request.aims = RUN_PAIR(CHANNELS_STEP, live);
}

// Writes the touches of the worlds of the first entries of the pool bay_copy.
static scree_status begin_touches(Block* block, int copies)
{
	const ChannelSet* outputs = block->sets + CHANNELS_OUTPUTS;
	if (!outputs->touches)
		return SCREE_OK;
	return run_groups(block, KERNEL_channel_body, CHANNELS_OUTPUTS, CHANNEL_COPIES | CHANNEL_BEGINS, copies, 0,
	                  outputs->joint_group);
}

scree_status block_apply_reset(Block* block, int resets)
{
	Backend* b = block->backend;
	if (!block->sets || resets == 0)
		return SCREE_OK;
	const ChannelSet* set = block->sets + CHANNELS_RESET;
	size_t columns = (size_t)set->columns;
	for (int k = 0; k < resets && set->parameters > 0; ++k)
		TRY(set_parameters(block, set, block->rows[k],
		                   memory_of(block, CHANNELS_RESET) + (size_t)block->rows[k] * columns));
	TRY(block_own_send(block));
	if (set->count == 0 && !block->sets[CHANNELS_OUTPUTS].touches)
		return SCREE_OK;
	for (int k = 0; k < resets && set->count > 0; ++k)
		channels_put(set, block->converted + (size_t)k * columns,
		             memory_of(block, CHANNELS_RESET) + (size_t)block->rows[k] * columns);
	TRY(b->f->write(b, POOL_bay_copy, 0, resets, block->copies));
	if (set->count > 0)
		TRY(b->f->write(b, POOL_column, block->lists[CHANNELS_RESET].column, resets * set->columns, block->converted));
	TRY(run_groups(block, KERNEL_channel_input, CHANNELS_RESET, CHANNEL_COPIES, resets, 0, set->groups));
	return begin_touches(block, resets);
}

scree_status block_begin_touches(Block* block, int copies)
{
	Backend* b = block->backend;
	int running = 0;
	for (int k = 0; k < copies; ++k)
		if (block->copies[k].y < block->worlds)
			block->copies[running++] = block->copies[k];
	if (!block->sets || !block->sets[CHANNELS_OUTPUTS].touches || running == 0)
		return SCREE_OK;
	TRY(b->f->write(b, POOL_bay_copy, 0, running, block->copies));
	return begin_touches(block, running);
}

scree_status block_write_outputs(Block* block)
{
	Backend* b = block->backend;
	const ChannelSet* set = block->sets ? block->sets + CHANNELS_OUTPUTS : NULL;
	if (!set || set->count == 0)
		return SCREE_OK;
	int rows = block->worlds, live = block->pipeline.live_bays;
	TRY(run_groups(block, KERNEL_channel_body, CHANNELS_OUTPUTS, 0, live, 0, set->joint_group));
	TRY(run_groups(block, KERNEL_channel_joint, CHANNELS_OUTPUTS, 0, live, set->joint_group, set->ray_group));
	TRY(run_groups(block, KERNEL_channel_ray, CHANNELS_OUTPUTS, 0, live, set->ray_group, set->groups));
	float* memory = memory_of(block, CHANNELS_OUTPUTS);
	float* to = converts(set) ? block->converted : memory;
	TRY(b->f->read(b, POOL_column, block->lists[CHANNELS_OUTPUTS].column, rows * set->columns, to));
	size_t columns = (size_t)set->columns;
	for (int k = 0; k < rows && converts(set); ++k)
		channels_get(set, memory + (size_t)k * columns, block->converted + (size_t)k * columns);
	return SCREE_OK;
}
