// SPDX-License-Identifier: MIT
// kept_state.c -- keeps a state of a world in host memory, and the calls since.
//
// Two saves take turns, because the last state must stay while the next one is being copied. A save of the user that is older than
// the kept state lies where it lay when it was copied, and newer ones never overlap it.
#include "world/recovery/kept_state.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/failure.h"
#include "world/record/call_codec.h"
#include "world/save/saves.h"
#include "world/structure.h"

#define UNIT (pool_info[POOL_saved].bytes)

// Copies a range of the pool `saved` to host memory, unless it is copied already.
static scree_status copy_range(scree_world* world, const KeptState* kept, SavedRange range, bool* copied)
{
	Backend* b = world->backend;
	uint8_t* to = kept->copy + UNIT * (size_t)range.first;
	if (!*copied && range.count > 0)
		TRY(world_note(world, b->f->read(b, POOL_saved, range.first, range.count, to)));
	*copied = true;
	return SCREE_OK;
}

static scree_status copy_saves(scree_world* world, const char* function, KeptState* kept)
{
	SaveList* list = world->saves.list;
	int items = world->saves.end;
	if (items > kept->items)
	{
		uint8_t* copy = scree_reallocate(kept->copy, UNIT * (size_t)kept->items, UNIT * (size_t)items);
		if (!copy)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a copy of %zu bytes of saves", function,
			            UNIT * (size_t)items);
		kept->copy = copy;
		kept->items = items;
	}
	for (int k = 0; k < SAVE_SLOTS; ++k)
		if (list->saves[k].made)
			TRY(copy_range(world, kept, list->saves[k].range, &list->saves[k].copied));
	for (int k = 0; k < SAVE_SLOTS + 1; ++k)
		if (list->structures[k].uses > 0)
			TRY(copy_range(world, kept, list->structures[k].range, &list->structures[k].copied));
	return SCREE_OK;
}

static int other_save(const KeptState* kept) { return kept->save == SCREE_SAVES ? SCREE_SAVES + 1 : SCREE_SAVES; }

scree_status kept_state_take(scree_world* world, const char* function, KeptState* kept)
{
	int save = other_save(kept);
	TRY(world_save(world, function, save));
	TRY(copy_saves(world, function, kept));
	kept->save = save;
	kept->step = world->pipeline.steps;
	kept->calls.used = 0;
	kept->count = 0;
	kept->saves = kept->read = 0;
	return SCREE_OK;
}

// Marks the saves that the calls since contain.
static void note_save(KeptState* kept, uint64_t number, const void* const* values)
{
	RecordedCallId call = (RecordedCallId)(number - RECORD_CALLS);
	if (number < RECORD_CALLS || (call != RECORDED_world_save && call != RECORDED_world_load))
		return;
	uint64_t bit = (uint64_t)1 << *(const int*)values[0];
	if (call == RECORDED_world_save)
		kept->saves |= bit;
	else
		kept->read |= bit & ~kept->saves;
}

bool kept_state_add(KeptState* kept, uint64_t number, const void* const* values)
{
	size_t used = kept->calls.used;
	kept->payload.used = 0;
	if (values)
		call_write(&kept->payload, (RecordedCallId)(number - RECORD_CALLS), values);
	bool whole = kept->payload.used != SIZE_MAX;
	if (whole)
		log_add(&kept->calls, &kept->chain, number, kept->payload.bytes, kept->payload.used);
	if (!whole || kept->calls.used == SIZE_MAX)
	{
		kept->calls.used = used;
		return false;
	}
	note_save(kept, number, values);
	++kept->count;
	return true;
}

scree_status kept_state_bring(const KeptState* kept, const char* function, scree_world* made)
{
	Backend* b = made->backend;
	// saves that the calls since make again, and a save in progress
	for (int k = 0; k < SCREE_SAVES; ++k)
		if (kept->saves >> k & 1)
			world_discard(made, k);
	world_discard(made, other_save(kept));
	TRY(pipeline_reserve(&made->pipeline, PER_SAVED, kept->items));
	TRY(b->f->write(b, POOL_saved, 0, kept->items, kept->copy));
	structure_changed(made); // no save has the structure of a new world
	TRY(world_load(made, function, kept->save, true));
	// steps lay chains and branches out, so a shared copy of the structure may lack them
	TRY(pipeline_reserve(&made->pipeline, PER_CHAIN, made->pipeline.chain_ranges));
	return pipeline_reserve(&made->pipeline, PER_BRANCH, made->pipeline.branch_nodes);
}

void kept_state_close(scree_world* world, KeptState* kept)
{
	SaveList* list = world->saves.list;
	for (int k = SCREE_SAVES; k < SAVE_SLOTS; ++k)
		world_discard(world, k);
	for (int k = 0; kept->copy && k < SAVE_SLOTS; ++k)
		list->saves[k].copied = false;
	for (int k = 0; kept->copy && k < SAVE_SLOTS + 1; ++k)
		list->structures[k].copied = false;
	scree_release(kept->copy);
	scree_release(kept->calls.bytes);
	scree_release(kept->payload.bytes);
	*kept = (KeptState){0};
}
