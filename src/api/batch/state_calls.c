// SPDX-License-Identifier: MIT
// state_calls.c -- saves and loads single worlds of a batch, takes worlds out of it and puts them back, for the user.
#include "api/batch/batch_check.h"
#include "batch/block_load.h"
#include "batch/block_rows.h"
#include "batch/fingerprint.h"
#include "batch/row_world.h"
#include "platform/processor.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/recovery/recovery.h"
#include <string.h>

size_t scree_batch_get_state_bytes(const scree_batch* batch)
{
	size_t most = 0;
	for (int k = 0; batch && k < batch->block_count; ++k)
	{
		size_t bytes = block_row_bytes(batch->blocks + k);
		most = bytes > most ? bytes : most;
	}
	return most;
}

static scree_status check_world(const scree_batch* batch, ArgumentPlace at, int world)
{
	if (world < 0 || world >= batch->worlds)
		return refuse(SCREE_ERROR_INVALID, at, "", "is %d, must be from 0 to %d", world, batch->worlds - 1);
	return SCREE_OK;
}

static scree_status check_worlds(const scree_batch* batch, const char* function, const int32_t* worlds, int count)
{
	if (count < 0)
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "count", ALONE}, "", "is %d, must be at least 0",
		              count);
	if (count > 0)
		TRY(check_pointer(function, "worlds", worlds));
	for (int k = 0; k < count; ++k)
		TRY(check_world(batch, (ArgumentPlace){function, "worlds", k}, worlds[k]));
	return SCREE_OK;
}

// Returns the number of the block of a world.
static int block_of(const scree_batch* batch, int world)
{
	int place = order_place(&batch->order, world), first = 0, end = batch->block_count;
	while (end - first > 1) // the block is one of `first` to end - 1
	{
		int middle = (first + end) / 2;
		if (batch->blocks[middle].first <= place)
			first = middle;
		else
			end = middle;
	}
	return first;
}

// Sorts the copies by block, with their order in each. Fails if `once` is set and a world occurs twice.
static scree_status sort_copies(const scree_batch* batch, const int32_t* worlds, int count, bool once, RowWork* work,
                                int** memory)
{
	size_t blocks = (size_t)batch->block_count,
	       places = blocks + 1 + (size_t)count + (once ? (size_t)batch->worlds : 0);
	*memory = scree_allocate(sizeof(int) * (places + 1));
	if (!*memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d worlds", work->function, count);
	int *begin = *memory, *order = begin + blocks + 2, *seen = order + count; // seen: 1 + index of the copy, per world
	for (int k = 0; k < count; ++k)
	{
		++begin[block_of(batch, worlds[k]) + 2];
		if (once && seen[worlds[k]])
			return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){work->function, "worlds", k}, "",
			              "is %d, as is worlds[%d]", worlds[k], seen[worlds[k]] - 1);
		if (once)
			seen[worlds[k]] = k + 1;
	}
	for (size_t k = 1; k <= blocks; ++k)
		begin[k + 1] += begin[k];
	for (int k = 0; k < count; ++k)
		order[begin[block_of(batch, worlds[k]) + 1]++] = k;
	work->begin = begin;
	work->order = order;
	return SCREE_OK;
}

static scree_status save_block(Block* block, const void* context) { return block_save(block, context); }
static scree_status check_block(Block* block, const void* context) { return block_check(block, context); }
static scree_status load_block(Block* block, const void* context) { return block_load(block, context); }

scree_status api_batch_save(scree_batch* batch, const int32_t* worlds, int count, void* states, size_t state_bytes)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_save";
	TRY(batch_check(batch, function));
	TRY(check_worlds(batch, function, worlds, count));
	if (count == 0)
		return SCREE_OK;
	TRY(check_pointer(function, "states", states));
	size_t least = scree_batch_get_state_bytes(batch);
	if (state_bytes < least)
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "state_bytes", ALONE}, "",
		              "is %zu, must be at least %zu (scree_batch_get_state_bytes)", state_bytes, least);
	RowWork work = {.function = function,
	                .blocks = batch->blocks,
	                .worlds = worlds,
	                .rows = states,
	                .row_bytes = state_bytes,
	                .bytes = least,
	                .version = row_version()};
	int* memory;
	scree_status status = sort_copies(batch, worlds, count, false, &work, &memory);
	if (status == SCREE_OK)
		status = batch_note(batch, batch_each(batch, save_block, &work));
	scree_release(memory);
	return status;
}

// Puts worlds into the states of rows. The worlds are checked.
static scree_status load_rows(scree_batch* batch, const char* function, const int32_t* worlds, int count,
                              const void* states, size_t state_bytes)
{
	RowWork work = {.function = function,
	                .blocks = batch->blocks,
	                .worlds = worlds,
	                .rows = (char*)states,
	                .row_bytes = state_bytes,
	                .bytes = state_bytes > 0 ? state_bytes : SIZE_MAX,
	                .version = row_version()};
	int* memory;
	scree_status status = sort_copies(batch, worlds, count, true, &work, &memory);
	if (status == SCREE_OK)
		status = batch_each(batch, check_block, &work);
	if (status == SCREE_OK)
		status = batch_note(batch, batch_each(batch, load_block, &work));
	scree_release(memory);
	return status;
}

scree_status api_batch_load(scree_batch* batch, const int32_t* worlds, int count, const void* states,
                            size_t state_bytes)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_load";
	TRY(batch_check(batch, function));
	TRY(check_worlds(batch, function, worlds, count));
	if (count == 0)
		return SCREE_OK;
	TRY(check_pointer(function, "states", states));
	return load_rows(batch, function, worlds, count, states, state_bytes);
}

// Makes a world with the structure of a template, and the state of a row. gravity: m/s^2.
static scree_status make_world(const char* function, const Template* from, scree_vec gravity,
                               const scree_world_def* def, const char* row, scree_world** made)
{
	scree_world_def alone = scree_world_def_default();
	alone.device = "cpu";
	alone.threads = 1;
	TRY(scree_world_clone(from->world, def ? def : &alone, made));
	(*made)->def.gravity = gravity;
	scree_status status = world_take_row(*made, function, from, row);
	if (status == SCREE_OK)
		status = recovery_begin(*made, function); // the state that is kept for recovery is that of the row
	if (status == SCREE_OK)
		return SCREE_OK;
	Sentence sentence = sentence_keep();
	scree_world_destroy(*made);
	*made = NULL;
	sentence_restore(&sentence);
	return status;
}

scree_status api_batch_extract(scree_batch* batch, int world, const scree_world_def* def, scree_world** made)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_extract";
	TRY(check_pointer(function, "made", made));
	*made = NULL;
	TRY(batch_check(batch, function));
	TRY(check_world(batch, (ArgumentPlace){function, "world", ALONE}, world));
	size_t bytes = scree_batch_get_state_bytes(batch);
	char* row = scree_allocate(bytes);
	if (!row)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a state of %zu bytes", function, bytes);
	scree_status status = api_batch_save(batch, &world, 1, row, bytes);
	const Template* from = batch->templates + batch->template_of[world];
	if (status == SCREE_OK)
		status =
		    make_world(function, from, batch->gravity ? batch->gravity[world] : from->request.gravity, def, row, made);
	scree_release(row);
	return status;
}

// Puts a world of a batch into the state of a world that was read.
static scree_status insert(scree_batch* batch, const char* function, int world, Template* read, const scree_world* from)
{
	const Template* now = batch->templates + batch->template_of[world];
	read->fingerprint = fingerprint_of(read, from);
	if (read->bodies != now->bodies || read->collidables != now->collidables || read->joints != now->joints)
		return fail(
		    SCREE_ERROR_INVALID,
		    "%s: from has %d bodies, %d collidables and %d joints, but the template of world %d has %d, %d and %d",
		    function, read->bodies, read->collidables, read->joints, world, now->bodies, now->collidables, now->joints);
	if (read->fingerprint != now->fingerprint)
		return fail(
		    SCREE_ERROR_INVALID,
		    "%s: from has other settings, or other shapes, densities, joints or rules, than the template of world %d",
		    function, world);
	uint64_t targets;
	if (!targets_find(&now->targets, &read->targets, &targets))
		return fail(SCREE_ERROR_INVALID, "%s: from has pending targets that the template of world %d lacks", function,
		            world);
	char* row;
	size_t bytes;
	TRY(row_of_world(read, targets, targets_hash(&now->targets, targets), function, &row, &bytes));
	scree_status status = load_rows(batch, function, &world, 1, row, bytes);
	scree_release(row);
	return status;
}

scree_status api_batch_insert(scree_batch* batch, int world, scree_world* from)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_insert";
	TRY(batch_check(batch, function));
	TRY(check_world(batch, (ArgumentPlace){function, "world", ALONE}, world));
	TRY(world_check(from, function));
	Template read;
	scree_status status = template_read(from, function, ALONE, &read);
	if (status == SCREE_OK)
		status = insert(batch, function, world, &read, from);
	template_close(&read);
	return status;
}
