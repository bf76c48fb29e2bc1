// SPDX-License-Identifier: MIT
// block_targets.c -- moves kinematic bodies of worlds of a block to the pending targets of their templates.
//
// The first step with dt above 0 reaches them, in each world since it was put back to its template. Commands are those of a
// world alone (world/objects/targets.c). A block whose templates have no targets has no memory for them.
#include "batch/block_targets.h"
#include "batch/block_own.h"
#include "batch/own_host.h"
#include "platform/error.h"

scree_status block_targets_open(Block* block)
{
	bool some = false;
	for (int t = 0; t < block->template_count; ++t)
		some |= block->spare_of[t] >= 0 && block->templates[t].targets.count > 0;
	if (!some)
		return SCREE_OK;
	block->targets = scree_allocate(sizeof *block->targets * (size_t)block->worlds);
	return block->targets ? SCREE_OK
	                      : fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the targets of %d worlds", block->worlds);
}

void block_targets_close(Block* block)
{
	scree_release(block->targets);
	scree_release(block->target_commands);
}

// Returns the bit of a body among the targets of a template, or 0.
static uint64_t target_bit(const TemplateTargets* targets, int body)
{
	for (int k = 0; k < targets->count; ++k)
		if (targets->items[k].command.index == body)
			return (uint64_t)1 << k;
	return 0;
}

// Returns the targets of a world's template that inputs of a list replace: velocities, and targets that the step reaches.
static uint64_t replaced(const Block* block, int list, int row)
{
	const Template* from = block_template(block, row);
	uint64_t set = 0;
	if (!block->sets || block->sets[list].count == 0)
		return 0;
	const ChannelSet* inputs = block->sets + list;
	const Channel* channels = inputs->channels + (from - block->templates) * inputs->count;
	Own own = own_of(from, block_own_values(block, row));
	for (int c = 0; c < inputs->count; ++c)
		if (channels[c].kind == CHANNEL_SET_VELOCITY ||
		    (channels[c].kind == CHANNEL_SET_TARGET && block->request.dt > 0.0f &&
		     !own.body[channels[c].item].disabled))
			set |= target_bit(&from->targets, channels[c].item);
	return set;
}

void block_targets_begin(Block* block, int row)
{
	if (block->targets)
		block->targets[row] = targets_all(&block_template(block, row)->targets) & ~replaced(block, CHANNELS_RESET, row);
}

void block_targets_replace(Block* block)
{
	for (int row = 0; block->targets && row < block->worlds; ++row)
		if (block->targets[row] != 0 && block_runs(block, row))
			block->targets[row] &= ~replaced(block, CHANNELS_STEP, row);
}

uint64_t block_targets_of(const Block* block, int row) { return block->targets ? block->targets[row] : 0; }

void block_targets_set(Block* block, int row, uint64_t set)
{
	if (block->targets)
		block->targets[row] = set;
}

// Returns the pending targets of a world that the next step reaches: those of disabled bodies stay.
static uint64_t reached(const Block* block, int row)
{
	const Template* from = block_template(block, row);
	if (block->targets[row] == 0 || !block_runs(block, row))
		return 0;
	Own own = own_of(from, block_own_values(block, row));
	uint64_t set = block->targets[row];
	for (int k = 0; k < from->targets.count; ++k)
		if (own.body[from->targets.items[k].command.index].disabled)
			set &= ~((uint64_t)1 << k);
	return set;
}

static int count_reached(const Block* block)
{
	int count = 0;
	for (int row = 0; row < block->worlds; ++row)
		for (uint64_t set = reached(block, row); set != 0; set &= set - 1)
			++count;
	return count;
}

static scree_status reserve(Block* block, int count)
{
	if (count <= block->target_capacity)
		return SCREE_OK;
	scree_release(block->target_commands);
	block->target_capacity = 0;
	block->target_commands = scree_allocate((size_t)count * (3 * sizeof(Command) + sizeof(int)) + sizeof(int));
	if (!block->target_commands)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d targets", count);
	block->target_capacity = count;
	return SCREE_OK;
}

scree_status block_targets_request(Block* block)
{
	StepCommands* commands = &block->request.commands;
	*commands = (StepCommands){.count = 0};
	if (!block->targets || !(block->request.dt > 0.0f))
		return SCREE_OK;
	int count = count_reached(block), sent = 0;
	if (count == 0)
		return SCREE_OK;
	TRY(reserve(block, count));
	Command *begin = block->target_commands, *end = begin + count, *undo = end + count;
	int* groups = (int*)(undo + count);
	for (int row = 0; row < block->worlds; ++row)
	{
		const Template* from = block_template(block, row);
		uint64_t set = reached(block, row);
		for (int k = 0; set != 0 && k < from->targets.count; ++k)
		{
			if (!(set >> k & 1))
				continue;
			begin[sent] = from->targets.items[k].command;
			begin[sent].index += block->bay_of[row] * block->pipeline.bays.bodies;
			end[sent] = begin[sent];
			end[sent].kind = COMMAND_ARRIVE;
			undo[sent] = (Command){.kind = COMMAND_VELOCITY, .index = begin[sent].index};
			groups[sent] = sent;
			++sent;
		}
	}
	groups[sent] = sent;
	*commands = (StepCommands){begin, end, undo, groups, count};
	return SCREE_OK;
}

void block_targets_end(Block* block)
{
	block->request.commands.count = 0;
	for (int row = 0; block->targets && block->request.dt > 0.0f && row < block->worlds; ++row)
		block->targets[row] &= ~reached(block, row);
}
