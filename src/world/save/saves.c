// SPDX-License-Identifier: MIT
// saves.c -- keeps saves of a world in the memory of its device, to which it goes back many times a second. A save
// contains the data that steps change. The rest, the structure, is shared by all saves between which it did not change.
#include "world/save/saves.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"
#include "world/failure.h"
#include "world/objects/reports.h"
#include "world/save/saved_host.h"
#include "world/save/saved_pools.h"
#include "world/snapshot/reported.h"
#include "world/upload/upload.h"
#include <string.h>

#define SPARE 32 // reciprocal of the share of a range that is left for a later save
#define GUESS 16 // number of items, of which one is taken to differ from its prediction before the first save

#define ZONES_FROM 8192 // number of items from which the values that differ have several zones, which cost some words
#define UNIT       4    // number of words of an item of the pool `saved`

#define STRUCTURES ((int)(sizeof((SaveList*)0)->structures / sizeof *((SaveList*)0)->structures))

// Returns the range of a save (below SAVE_SLOTS) or of a structure.
static SavedRange range_at(const SaveList* list, int k)
{
	return k < SAVE_SLOTS ? list->saves[k].range : list->structures[k - SAVE_SLOTS].range;
}

static bool is_free(const SaveList* list, SavedRange range)
{
	for (int k = 0; k < SAVE_SLOTS + STRUCTURES; ++k)
	{
		SavedRange other = range_at(list, k);
		if (other.count > 0 && range.first < other.first + other.count && other.first < range.first + range.count)
			return false;
	}
	return true;
}

static void measure(Saves* saves)
{
	saves->end = 0;
	for (int k = 0; k < SAVE_SLOTS + STRUCTURES; ++k)
	{
		SavedRange range = range_at(saves->list, k);
		saves->end = range.first + range.count > saves->end ? range.first + range.count : saves->end;
	}
}

// Finds the lowest free range of at least `count` items, or keeps *range if it is large enough.
static scree_status find_range(scree_world* world, const char* function, int64_t count, SavedRange* range)
{
	const SaveList* list = world->saves.list;
	if (count <= range->count)
		return SCREE_OK;
	count = (count + count / SPARE + ALIGNED - 1) / ALIGNED * ALIGNED;
	int64_t lowest = INT32_MAX;
	for (int k = -1; k < SAVE_SLOTS + STRUCTURES; ++k)
	{
		SavedRange after = k < 0 ? (SavedRange){0, 0} : range_at(list, k);
		int64_t first = after.first + after.count;
		if (first + count < INT32_MAX / 2 && first < lowest && is_free(list, (SavedRange){(int)first, (int)count}))
			lowest = first;
	}
	if (lowest == INT32_MAX)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: saves of more than 16 GB", function);
	TRY(world_note(world, pipeline_reserve(&world->pipeline, PER_SAVED, (int)(lowest + count))));
	*range = (SavedRange){(int)lowest, (int)count};
	return SCREE_OK;
}

static scree_status fill_structure(scree_world* world, const char* function, SavedStructure* structure)
{
	int64_t count = saved_pools_count(world, true, structure->counts);
	TRY(saved_structure_write(world, function, &structure->host));
	TRY(find_range(world, function, count, &structure->range));
	measure(&world->saves);
	return world_note(world, saved_pools_copy(world, true, structure->range, structure->counts, NULL, false));
}

// Finds the copy of the present structure, or makes one. Sets *index to its number.
static scree_status find_structure(scree_world* world, const char* function, int* index)
{
	SaveList* list = world->saves.list;
	int unused = -1;
	for (int k = 0; k < STRUCTURES; ++k)
	{
		*index = k;
		if (list->structures[k].uses > 0 && list->structures[k].version == world->saves.version)
			return SCREE_OK;
		unused = list->structures[k].uses == 0 ? k : unused;
	}
	*index = unused;
	TRY(fill_structure(world, function, list->structures + unused));
	list->structures[unused].copied = false;
	list->structures[unused].version = world->saves.version;
	return SCREE_OK;
}

static void give_up(SaveList* list, Save* save)
{
	if (save->made)
		--list->structures[save->structure].uses;
	save->made = false;
}

// Packs the items of a save, again if too many values differed from their predictions. Waits for the last step.
static scree_status pack(scree_world* world, const char* function, Save* save)
{
	Backend* b = world->backend;
	int64_t copied = saved_pools_count(world, false, save->counts), words = saved_words_count(world, 0, &save->layout);
	const SavedLayout* l = &save->layout;
	int64_t items = (int64_t)l->bodies.count + l->collidables.count + l->contacts.count;
	int zones = items < ZONES_FROM ? 1 : SAVED_ZONES;
	int64_t room = (world->saves.rest > 0 ? world->saves.rest : items / GUESS) / zones + 1;
	save->material_pairs = world->pipeline.material_pairs;
	for (;;)
	{
		int used[SAVED_ZONES];
		TRY(find_range(world, function, copied + (words + zones * room) / UNIT + 1, &save->range));
		saved_words_count(world, save->range.first + (int)copied, &save->layout);
		save->layout.zones = zones;
		save->layout.room = (int)((UNIT * (save->range.count - copied) - words) / zones);
		TRY(world_note(world, b->f->clear(b, POOL_saved, save->layout.first, SAVED_HEAD / UNIT)));
		TRY(world_note(world, saved_words_run(world, save, false)));
		// before the read, because a device copies while it still gets commands
		TRY(world_note(world, saved_pools_copy(world, false, save->range, save->counts, save->leaves, false)));
		TRY(world_note(world, b->f->read(b, POOL_saved, save->layout.first, SAVED_HEAD / UNIT, used)));
		room = 0;
		for (int k = 0; k < zones; ++k)
			room = used[k] > room ? used[k] : room;
		world->saves.rest = zones * room;
		if (room <= save->layout.room)
			return SCREE_OK;
	}
}

scree_status world_save(scree_world* world, const char* function, int number)
{
	if (!world->saves.list)
		world->saves.list = scree_allocate(sizeof *world->saves.list);
	SaveList* list = world->saves.list;
	if (!list)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for saves", function);
	TRY(world_upload(world));
	TRY(reports_fetch(world));
	TRY(world_note(world, tree_upload(&world->pipeline))); // appends new leaves
	Save* save = list->saves + number;
	Save made = {.made = true};
	TRY(find_structure(world, function, &made.structure));
	for (int t = 0; t < 2; ++t)
		made.leaves[t] = world->pipeline.trees[t].tree.leaves;
	made.range = save->range;
	scree_status status = saved_step_write(world, function, &save->host);
	if (status == SCREE_OK)
		status = pack(world, function, &made);
	++list->structures[made.structure].uses; // before the old use ends, so that the structure stays
	give_up(list, save);
	made.host = save->host;
	made.made = status == SCREE_OK;
	if (status != SCREE_OK)
	{
		--list->structures[made.structure].uses;
		made.range = (SavedRange){0, 0}; // the pool may lack it after the loss of a device
	}
	*save = made;
	measure(&world->saves);
	return status;
}

// Reserves memory for what the user has read, and copies it.
static scree_status hide_reported(scree_world* world, const HostLoad* host, Reported* reported)
{
	SavedRange range = {0, 0};
	TRY(find_range(world, host->function, reported_items(world), &range));
	reported->at = range.first;
	return world_note(world, reported_take(world, host->function, host->same, reported));
}

// reported: null if the save also contains what the user has read.
static scree_status load_all(scree_world* world, const Save* save, HostLoad* host, Reported* reported)
{
	const SavedStructure* structure = world->saves.list->structures + save->structure;
	Backend* b = world->backend;
	TRY(saved_host_reserve(host));
	TRY(world_note(world, saved_pools_reserve(world, save->counts)));
	if (!host->same)
		TRY(world_note(world, saved_pools_reserve(world, structure->counts)));
	reported = reported && reported_items(world) > 0 ? reported : NULL;
	if (reported)
		TRY(hide_reported(world, host, reported));
	scree_status status = SCREE_OK;
	if (!host->same) // first, because the values of other items follow from it
		status = saved_pools_copy(world, true, structure->range, structure->counts, NULL, true);
	if (status == SCREE_OK)
		status = saved_pools_copy(world, false, save->range, save->counts, save->leaves, true);
	if (status == SCREE_OK)
		status = saved_words_run(world, save, true);
	if (status == SCREE_OK) // bodies jump to the poses of the save
		status = b->f->clear(b, POOL_start_pose, 0, b->capacity[PER_BODY]);
	if (status == SCREE_OK)
	{
		saved_host_read(host);
		if (reported)
			status = reported_return(world, reported);
		world->saves.version = structure->version;
		pipeline_move(&world->pipeline, b);
		Counters counters; // this read also stores the counters in the backend, and reports failed copies
		if (status == SCREE_OK)
			status = b->f->read(b, POOL_counters, 0, 1, &counters);
	}
	if (status != SCREE_OK)
		world->broken = status;
	return status;
}

scree_status world_load(scree_world* world, const char* function, int number, bool reports)
{
	const SaveList* list = world->saves.list;
	if (!list || !list->saves[number].made)
		return fail(SCREE_ERROR_INVALID, "%s: the world has no save %d", function, number);
	TRY(world_upload(world)); // afterwards no edit is pending
	const Save* save = list->saves + number;
	const SavedStructure* structure = list->structures + save->structure;
	HostLoad host = {.function = function,
	                 .world = world,
	                 .structure = &structure->host,
	                 .step = &save->host,
	                 .same = structure->version == world->saves.version};
	Reported reported = {0};
	scree_status status = load_all(world, save, &host, reports ? NULL : &reported);
	reported_close(&reported);
	saved_host_close(&host);
	return status;
}

uint64_t world_save_bytes(const scree_world* world, int number)
{
	const SaveList* list = world->saves.list;
	return list && list->saves[number].made ? (uint64_t)list->saves[number].range.count * pool_info[POOL_saved].bytes
	                                        : 0;
}

void world_discard(scree_world* world, int number)
{
	SaveList* list = world->saves.list;
	if (!list)
		return;
	Save* save = list->saves + number;
	give_up(list, save);
	scree_release(save->host.bytes);
	*save = (Save){0};
	for (int k = 0; k < STRUCTURES; ++k)
		if (list->structures[k].uses == 0)
		{
			scree_release(list->structures[k].host.bytes);
			list->structures[k] = (SavedStructure){0};
		}
	measure(&world->saves);
}

void saves_close(scree_world* world)
{
	for (int k = 0; k < SAVE_SLOTS; ++k)
		world_discard(world, k);
	scree_release(world->saves.list);
}
