// SPDX-License-Identifier: MIT
// block_bind.c -- writes the lists of channels to the pools of a block, and makes room for their rows.
#include "batch/block_bind.h"
#include "batch/block_channels.h"
#include "platform/error.h"
#include "step/reserve.h"

#define ALIGNED 64 // columns: rows of a list begin at a multiple of this

// Computes the places of all lists. Returns the numbers of channels, of groups and of columns.
static void lay_out(Block* block, int templates, int* channels, int* groups, int64_t* columns)
{
	*channels = *groups = 0;
	*columns = 0;
	// outputs come first, so that they keep their places when inputs are bound
	static const int order[CHANNEL_LISTS] = {CHANNELS_OUTPUTS, CHANNELS_STEP, CHANNELS_RESET};
	for (int n = 0; n < CHANNEL_LISTS; ++n)
	{
		int k = order[n];
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
		if (k != CHANNELS_STEP)
			continue;
		block->lists[k].bounds = (int)*columns;
		*columns += 2 * set->columns;
	}
}

static scree_status reserve_rows(Block* block)
{
	int columns = block->sets[CHANNELS_RESET].columns;
	for (int k = 0; k < CHANNEL_LISTS; ++k)
		if (block_converts(block, block->sets + k) && block->sets[k].columns > columns)
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
	if (which == CHANNELS_STEP && set->columns > 0)
	{
		TRY(b->f->write(b, POOL_column, list->bounds, set->columns, set->least));
		TRY(b->f->write(b, POOL_column, list->bounds + set->columns, set->columns, set->most));
	}
	bool same = which == CHANNELS_OUTPUTS && block->outputs == set->channels; // rows of paused worlds stay
	return same ? SCREE_OK : b->f->clear(b, POOL_column, list->column, block->worlds * set->columns);
}

// Returns whether outputs of joints can be written in lanes: all are angles or their speeds, of the same template.
static bool has_angles_only(const Block* block)
{
	const ChannelSet* set = block->sets + CHANNELS_OUTPUTS;
	int number = block->template_of[block->first];
	const Template* from = block->templates + number;
	if (block->backend->distant || block->backend->lanes == 1 || set->count == 0)
		return false;
	for (int t = 0; t < block->template_count; ++t)
		if (block->spare_of[t] >= 0 && t != number)
			return false;
	for (int k = set->group[set->joint_group]; k < set->group[set->ray_group]; ++k)
	{
		const Channel* c = set->channels + number * set->count + k;
		bool angle =
		    c->which == JOINT_ANGLE && (c->kind == CHANNEL_GET_JOINT_VALUE || c->kind == CHANNEL_GET_JOINT_SPEED);
		if (!angle || (int)from->image.joint_data[c->item].modes & (JOINT_COUPLED | JOINT_RAILED))
			return false;
	}
	return set->ray_group > set->joint_group;
}

scree_status block_bind(Block* block, const ChannelSet* sets, int templates)
{
	Backend* b = block->backend;
	Pipeline* p = &block->pipeline;
	int channels, groups;
	int64_t columns;
	block->sets = sets;
	block->angles = has_angles_only(block);
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
	if (block->outputs == outputs->channels)
		return SCREE_OK;
	block->outputs = outputs->channels;
	for (int row = 0; row < block->worlds; ++row)
		block->paused[row].uncounted = !block_runs(block, row);
	return block_write_touches(block, 0, p->live_bays);
}
