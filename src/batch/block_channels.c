// SPDX-License-Identifier: MIT
// block_channels.c -- moves rows of inputs and outputs between the memory of the user and the pools of a block.
#include "batch/block_channels.h"
#include "batch/block_gravity.h"
#include "batch/block_own.h"
#include "batch/channel_rows.h"
#include "batch/own_inputs.h"
#include "platform/error.h"
#include "step/bay_layout.h"

// Returns memory of the user for the row of a world.
static float* memory_of(const Block* block, int which, int row)
{
	const ChannelSet* set = block->sets + which;
	return set->memory + (size_t)block_world(block, row) * (size_t)set->columns;
}

// Returns a run over groups of channels, from `begin` on, of `rows` worlds. bits: CHANNEL_*.
static Run groups_run(int kernel, int which, int bits, int rows, int begin, int end)
{
	int groups = end - begin;
	return (Run){kernel, 0, groups * rows, NO_COUNT, RUN_PAIR(which | bits, CHANNEL_GROUPS(begin, groups))};
}

bool block_converts(const Block* block, const ChannelSet* set)
{
	return set->poses || set->unit != 0.0 || block->order->world;
}

// Returns a number of rows, rounded up to a multiple of MAX_LANES.
static int padded(int rows) { return (rows + MAX_LANES - 1) / MAX_LANES * MAX_LANES; }

// Returns whether some output counts touches.
static bool counts_touches(const Block* block)
{
	const ChannelSet* set = block->sets + CHANNELS_OUTPUTS;
	return set->joint_group > set->touch_group;
}

scree_status block_write_touches(Block* block, int bits, int rows)
{
	const ChannelSet* set = block->sets + CHANNELS_OUTPUTS;
	Run run = groups_run(KERNEL_channel_touch, CHANNELS_OUTPUTS, bits, rows, set->touch_group, set->joint_group);
	return bays_run_all(&block->pipeline, &run, 1);
}

// Applies inputs to `rows` worlds: those of list `which`.
static scree_status apply(Block* block, int which, int bits, int rows)
{
	const ChannelSet* set = block->sets + which;
	Pipeline* p = &block->pipeline;
	p->edited = true;
	const Run runs[] = {groups_run(KERNEL_channel_input, which, bits, rows, 0, set->groups),
	                    {KERNEL_channel_stir, 0, rows, NO_COUNT, RUN_PAIR(which | bits, rows)}};
	return bays_run_all(p, runs, p->sleeps && (set->groups > set->joint_group || (set->poses && p->paths)) ? 2 : 1);
}

// Returns the row of inputs of a world in metres. room: for MOST_COLUMNS values.
static const float* metric_row(const Block* block, int list, int row, float* room)
{
	const ChannelSet* set = block->sets + list;
	const float* values = memory_of(block, list, row);
	if (set->unit == 0.0)
		return values;
	channels_put(set, room, values);
	return room;
}

scree_status block_check_masses(Block* block, int list, const uint8_t* mask, const char* function)
{
	float room[MOST_COLUMNS];
	for (int row = 0; row < block->worlds; ++row)
	{
		int world = block_world(block, row), number = block_number(block, row);
		if (list == CHANNELS_RESET ? mask && !mask[world] : !block_runs(block, row))
			continue;
		if (list == CHANNELS_RESET && block->next_of)
			number = block->next_of[world];
		const Template* from = block->templates + number;
		Own own = own_of(from, list == CHANNELS_RESET ? from->own : block_own_values(block, row));
		TRY(own_inputs_check(block->sets + list, function, from, own, number, metric_row(block, list, row, room),
		                     world));
	}
	return SCREE_OK;
}

// Gives worlds the gravity of their inputs, and wakes those in which it changes. rows: as in set_parameters.
static scree_status pull(Block* block, int list, const int* rows, int count)
{
	float room[MOST_COLUMNS];
	bool sleeps = block->pipeline.sleeps;
	scree_vec* before = sleeps ? scree_allocate(sizeof *before * (size_t)(count + 1)) : NULL;
	if (sleeps && !before)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the gravity of %d worlds", count);
	for (int k = 0; k < count; ++k)
	{
		int row = rows ? rows[k] : k;
		if (sleeps)
			before[k] = block_world_gravity(block, row);
		if (block_runs(block, row))
			own_inputs_pull(block, block->sets + list, row, metric_row(block, list, row, room));
	}
	scree_status status = block_wake(block, rows, before, count);
	scree_release(before);
	return status;
}

// Applies the parameters of a list to worlds that run. rows: rows of the worlds, null for the first `count` rows.
static scree_status set_parameters(Block* block, int list, const int* rows, int count)
{
	float room[MOST_COLUMNS];
	const ChannelSet* set = block->sets + list;
	if (set->parameters == 0)
		return SCREE_OK;
	if (set->pulls)
		TRY(pull(block, list, rows, count));
	for (int k = 0; k < count && set->owns; ++k)
	{
		int row = rows ? rows[k] : k;
		if (block_runs(block, row))
			TRY(own_inputs_set(block, set, row, metric_row(block, list, row, room)));
	}
	return block_own_send(block);
}

scree_status block_set_parameters(Block* block)
{
	return block->sets ? set_parameters(block, CHANNELS_STEP, NULL, block->worlds) : SCREE_OK;
}

// Returns the place of the rows of a block in shared memory, bytes. All worlds have one tuning, so they are in the order of the user.
static size_t shared_offset(const Block* block, const ChannelSet* set)
{
	return sizeof(float) * (size_t)block->first * (size_t)set->columns;
}

scree_status block_check_shared(Block* block, const char* function)
{
	Backend* b = block->backend;
	const ChannelSet* set = block->sets + CHANNELS_STEP;
	ChannelList* list = block->lists + CHANNELS_STEP;
	int columns = set->columns, values = block->worlds * columns;
	TRY(b->f->download(b, SHARED_INPUTS, POOL_column, list->column, values, shared_offset(block, set)));
	TRY(bays_run(&block->pipeline, KERNEL_channel_check, 0, values, CHANNELS_STEP));
	ChannelList checked;
	TRY(b->f->read(b, POOL_channel_list, CHANNELS_STEP, 1, &checked));
	if (checked.wrong == 0)
		return SCREE_OK;
	float row[MOST_COLUMNS];
	int world = (values - checked.wrong) / columns;
	TRY(b->f->write(b, POOL_channel_list, CHANNELS_STEP, 1, list)); // `wrong` is 0
	TRY(b->f->read(b, POOL_column, list->column + world * columns, columns, row));
	return channels_check_row(set, function, row, block->first + world);
}

scree_status block_apply_inputs(Block* block)
{
	Backend* b = block->backend;
	if (!block->sets || block->sets[CHANNELS_STEP].count == 0)
		return SCREE_OK;
	const ChannelSet* set = block->sets + CHANNELS_STEP;
	size_t columns = (size_t)set->columns;
	bool converted = block_converts(block, set);
	if (set->shared) // block_check_shared has copied the rows
		return apply(block, CHANNELS_STEP, 0, block->pipeline.live_bays);
	for (int k = 0; k < block->worlds && converted; ++k)
		channels_put(set, block->converted + (size_t)k * columns, memory_of(block, CHANNELS_STEP, k));
	TRY(b->f->write(b, POOL_column, block->lists[CHANNELS_STEP].column, block->worlds * set->columns,
	                converted ? block->converted : memory_of(block, CHANNELS_STEP, 0)));
	return apply(block, CHANNELS_STEP, 0, block->pipeline.live_bays);
}

scree_status block_apply_again(Block* block)
{
	bool acts = block->sets && block->sets[CHANNELS_STEP].acts;
	return acts ? apply(block, CHANNELS_STEP, CHANNEL_AGAIN, block->pipeline.live_bays) : SCREE_OK;
}

void block_aim(Block* block, bool first)
{
	const ChannelSet* set = block->sets ? block->sets + CHANNELS_STEP : NULL;
	int groups = first && block->request.dt > 0.0f && set && set->aims ? set->joint_group : 0;
	block->request.targets = groups * block->pipeline.live_bays;
	block->request.aims = RUN_PAIR(CHANNELS_STEP, CHANNEL_GROUPS(0, groups));
}

scree_status block_apply_reset(Block* block, int resets)
{
	Backend* b = block->backend;
	if (!block->sets || resets == 0)
		return SCREE_OK;
	const ChannelSet* set = block->sets + CHANNELS_RESET;
	size_t columns = (size_t)set->columns;
	TRY(set_parameters(block, CHANNELS_RESET, block->rows, resets));
	if (set->count == 0 && !counts_touches(block))
		return SCREE_OK;
	for (int k = 0; k < resets && set->count > 0; ++k)
		channels_put(set, block->converted + (size_t)k * columns, memory_of(block, CHANNELS_RESET, block->rows[k]));
	TRY(b->f->write(b, POOL_bay_copy, 0, resets, block->copies));
	if (set->count > 0)
		TRY(b->f->write(b, POOL_column, block->lists[CHANNELS_RESET].column, resets * set->columns, block->converted));
	TRY(apply(block, CHANNELS_RESET, CHANNEL_COPIES, resets));
	return block_write_touches(block, CHANNEL_COPIES, resets);
}

scree_status block_begin_touches(Block* block, int copies)
{
	Backend* b = block->backend;
	int running = 0;
	for (int k = 0; k < copies; ++k)
		if (block->copies[k].y < block->worlds)
			block->copies[running++] = block->copies[k];
	if (!block->sets || !counts_touches(block) || running == 0)
		return SCREE_OK;
	TRY(b->f->write(b, POOL_bay_copy, 0, running, block->copies));
	return block_write_touches(block, CHANNEL_COPIES, running);
}

scree_status block_write_outputs(Block* block)
{
	Backend* b = block->backend;
	const ChannelSet* set = block->sets ? block->sets + CHANNELS_OUTPUTS : NULL;
	if (!set || set->count == 0)
		return SCREE_OK;
	int rows = block->worlds, live = block->pipeline.live_bays, joints = set->joint_group, rays = set->ray_group;
	Run runs[] = {groups_run(KERNEL_channel_body, CHANNELS_OUTPUTS, 0, live, 0, set->touch_group),
	              groups_run(KERNEL_channel_touch, CHANNELS_OUTPUTS, 0, live, set->touch_group, joints),
	              groups_run(KERNEL_channel_joint, CHANNELS_OUTPUTS, 0, live, joints, rays),
	              groups_run(KERNEL_channel_ray, CHANNELS_OUTPUTS, 0, live, rays, set->groups)};
	if (block->angles)
		runs[2] = (Run){KERNEL_channel_angles, joints * padded(live), rays * padded(live), NO_COUNT,
		                RUN_PAIR(CHANNELS_OUTPUTS, live)};
	TRY(bays_run_all(&block->pipeline, runs, sizeof runs / sizeof *runs));
	if (set->shared)
		return b->f->upload(b, SHARED_OUTPUTS, POOL_column, block->lists[CHANNELS_OUTPUTS].column, rows * set->columns,
		                    shared_offset(block, set));
	bool converted = block_converts(block, set);
	float* to = converted ? block->converted : memory_of(block, CHANNELS_OUTPUTS, 0);
	TRY(b->f->read(b, POOL_column, block->lists[CHANNELS_OUTPUTS].column, rows * set->columns, to));
	size_t columns = (size_t)set->columns;
	for (int k = 0; k < rows && converted; ++k)
		channels_get(set, memory_of(block, CHANNELS_OUTPUTS, k), block->converted + (size_t)k * columns);
	return SCREE_OK;
}
