// SPDX-License-Identifier: MIT
// channel_calls.c -- binds channels of a batch, and observes its worlds.
#include "api/batch/batch_check.h"
#include "batch/block_bind.h"
#include "batch/channel_rows.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/record/api_calls.h"
#include <stddef.h>

static const DefinitionType channel_definition = {
    sizeof(scree_channel), offsetof(scree_channel, mask) + sizeof(uint64_t), "scree_channel_make"};

void scree_channel_make_sized(scree_channel_kind kind, scree_channel* channel, size_t size)
{
	scree_channel made = {.kind = kind, .rays = 1, .category = UINT64_MAX, .mask = UINT64_MAX};
	if (!channel)
		return;
	write_result(channel, size, &made, sizeof made);
	channel->size = (uint32_t)size;
}

static scree_status check_list_number(const char* function, scree_channels list)
{
	if ((int)list >= 0 && (int)list < CHANNEL_LISTS)
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "list", ALONE}, "", "is %d, not a list of channels",
	              (int)list);
}

static scree_status bind_block(Block* block, const void* context)
{
	const scree_batch* batch = context;
	return block_bind(block, batch->sets, batch->template_count);
}

static scree_status open_set(scree_batch* batch, const char* function, scree_channels list,
                             const scree_channel* channels, int count, ChannelSet* set)
{
	scree_channel* now = scree_allocate(sizeof *now * (size_t)(count + 1));
	if (!now)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d channels", function, count);
	scree_status status = SCREE_OK;
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		status = check_definition((ArgumentPlace){function, "channels", 0}, channels, k, &channel_definition);
		scree_channel local;
		if (status == SCREE_OK)
			now[k] = *(const scree_channel*)definition_at(channels, k, &channel_definition, &local);
		if (status == SCREE_OK && list == SCREE_RESET_INPUTS && now[k].kind == SCREE_INPUT_TARGET)
			status = refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "channels", k}, ".kind",
			                "is a target, which only a step can reach; bind it as SCREE_STEP_INPUTS");
	}
	if (status == SCREE_OK)
		status =
		    channels_open(set, function, list != SCREE_OUTPUTS, now, count, batch->templates, batch->template_count);
	scree_release(now);
	return status;
}

// Gives all blocks the memory of a list, or none with null. The first block becomes the owner of the file descriptor. On failure no
// block has memory.
static scree_status share(scree_batch* batch, scree_channels list, const SharedMemory* memory)
{
	SharedUse use = list == SCREE_OUTPUTS ? SHARED_OUTPUTS : SHARED_INPUTS;
	scree_status status = SCREE_OK;
	for (int k = batch->block_count - 1; k >= 0 && status == SCREE_OK; --k)
	{
		Backend* b = batch->blocks[k].backend;
		SharedMemory part = memory ? *memory : (SharedMemory){.file = -1};
		part.copies_file = k > 0;
		status = b->f->share(b, use, memory ? &part : NULL);
	}
	for (int k = 1; k < batch->block_count && status != SCREE_OK && memory; ++k)
		batch->blocks[k].backend->f->share(batch->blocks[k].backend, use, NULL);
	return status;
}

// Replaces a list of channels. On failure `*set` is closed, and the list stays as it was.
static scree_status replace(scree_batch* batch, scree_channels list, ChannelSet* set)
{
	ChannelSet before = batch->sets[list];
	batch->sets[list] = *set;
	scree_status status = batch_each(batch, bind_block, batch);
	if (status == SCREE_OK)
	{
		if (before.shared)
			status = batch_note(batch, share(batch, list, NULL));
		channel_rows_close(&before);
		channels_close(&before);
		return status;
	}
	batch->sets[list] = before; // blocks whose pools could not grow get the lists before again
	if (batch_each(batch, bind_block, batch) != SCREE_OK)
		batch->broken = status;
	return status;
}

scree_status api_batch_bind(scree_batch* batch, scree_channels list, const scree_channel* channels, int count,
                            float* memory)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_bind";
	TRY(batch_check(batch, function));
	TRY(check_list_number(function, list));
	TRY(check_batch(function, "channels", channels, count));
	ChannelSet set = {0};
	scree_status status = open_set(batch, function, list, channels, count, &set);
	set.memory = memory;
	if (status == SCREE_OK && set.pulls)
		status = batch_own_gravity(batch, function);
	if (status == SCREE_OK && count > 0 && !memory)
		status = channel_rows_open(&set, function, batch->worlds, batch->blocks[0].backend);
	if (status == SCREE_OK)
		status = replace(batch, list, &set);
	if (status != SCREE_OK)
	{
		channel_rows_close(&set);
		channels_close(&set);
	}
	return status;
}

// Returns whether a list can be shared, whose rows must be in the order of the user, and have the values that kernels read.
static scree_status check_share(const scree_batch* batch, const char* function, scree_channels list, size_t bytes)
{
	const ChannelSet* set = batch->sets + list;
	const Backend* b = batch->blocks[0].backend;
	size_t least = sizeof(float) * (size_t)batch->worlds * (size_t)set->columns;
	if (list == SCREE_RESET_INPUTS)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: the inputs of resets are in memory of the host", function);
	if (set->columns == 0)
		return fail(SCREE_ERROR_INVALID, "%s: list %d has no channels; scree_batch_bind comes first", function,
		            (int)list);
	if (b->sharing != SCREE_SHARING_MEMORY)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: the rows of a batch on %s are %s", function, b->name,
		            scree_sharing_name(SCREE_SHARING_COPIED));
	if (batch->order.groups > 1)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: templates have different tunings, so the rows are not in one place",
		            function);
	if (set->unit != 0.0)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: memory is shared in metres, and scree_world_def.length_unit is %s",
		            function, decimal((float)set->unit).text);
	if (set->poses || set->parameters > 0)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: the host must read inputs that are poses, targets or parameters",
		            function);
	if (bytes < least)
		return fail(SCREE_ERROR_INVALID, "%s: bytes is %zu, must be at least %zu for %d worlds and %d columns",
		            function, bytes, least, batch->worlds, set->columns);
	return SCREE_OK;
}

scree_status api_batch_share_rows(scree_batch* batch, scree_channels list, int file_descriptor, size_t bytes)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_share_rows";
	TRY(batch_check(batch, function));
	TRY(check_list_number(function, list));
	if (file_descriptor < 0)
		return fail(SCREE_ERROR_INVALID, "%s: file_descriptor is %d, must not be negative", function, file_descriptor);
	TRY(check_share(batch, function, list, bytes));
	SharedMemory memory = {.how = SCREE_SHARING_MEMORY, .file = file_descriptor, .bytes = bytes};
	TRY(batch_note_device(batch, share(batch, list, &memory)));
	channel_rows_close(batch->sets + list);
	batch->sets[list].shared = true;
	return SCREE_OK;
}

float* scree_batch_get_rows(const scree_batch* batch, scree_channels list)
{
	return batch && (int)list >= 0 && (int)list < CHANNEL_LISTS ? batch->sets[list].memory : NULL;
}

int scree_batch_get_columns(const scree_batch* batch, scree_channels list)
{
	return batch && (int)list >= 0 && (int)list < CHANNEL_LISTS ? batch->sets[list].columns : 0;
}

static scree_status observe_block(Block* block, const void* context)
{
	(void)context;
	return block_write_outputs(block);
}

scree_status api_batch_observe(scree_batch* batch)
{
	FLOAT_MODE_HERE;
	TRY(batch_check(batch, "scree_batch_observe"));
	return batch_note(batch, batch_each(batch, observe_block, NULL));
}
