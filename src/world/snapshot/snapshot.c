// SPDX-License-Identifier: MIT
// snapshot.c -- writes a world as a snapshot: what a move to another device copies (world/device/migrate.c), and the data on
// the host.
#include "world/snapshot/snapshot.h"
#include "platform/error.h"
#include "step/tree_maintenance.h"
#include "world/device/lasting.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/collidables.h"
#include "world/objects/reports.h"
#include "world/pool_read.h"
#include "world/snapshot/host_lists.h"
#include "world/snapshot/pool_columns.h"
#include "world/upload/upload.h"

// Sets *items to the items of a pool: in memory of the backend, or read into `memory`.
static scree_status pool_items(scree_world* world, PoolId pool, int first, int count, void* memory, const void** items)
{
	Backend* b = world->backend;
	*items = pool_item_address(b, pool, first);
	if (*items)
		return SCREE_OK;
	*items = memory;
	return count > 0 ? world_note(world, b->f->read(b, pool, first, count, memory)) : SCREE_OK;
}

// Writes the leaves of a tree whose collidables are still in it, in their order.
static scree_status write_leaves(ChunkWriter* writer, scree_world* world, int t, int* memory)
{
	int count = world->pipeline.trees[t].tree.leaves, kept = 0;
	const void* items;
	TRY(pool_items(world, POOL_leaf, t * world->backend->capacity[PER_COLLIDABLE], count, memory, &items));
	const int* leaves = items;
	for (int k = 0; k < count; ++k)
		if (collidable_in_tree(world, leaves[k], t))
			memory[kept++] = leaves[k];
	columns_write(writer, leaf_tables + t, memory, sizeof *memory, kept);
	return SCREE_OK;
}

static scree_status write_pools(ChunkWriter* writer, scree_world* world, void* memory)
{
	PoolColumns columns;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (!pool_columns((PoolId)pool, &columns))
			continue;
		int count = lasting_items(world, pool_info[pool].per);
		const void* items;
		TRY(pool_items(world, (PoolId)pool, 0, count, memory, &items));
		columns_write(writer, &columns.table, items, pool_info[pool].bytes, count);
	}
	TRY(write_leaves(writer, world, 0, memory));
	return write_leaves(writer, world, 1, memory);
}

// Returns the size of the largest pool that a snapshot contains, or of the leaves of a tree, bytes.
static size_t largest_pool(const scree_world* world)
{
	PoolColumns columns;
	size_t largest = sizeof(int) * (size_t)world->collidables.capacity;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t bytes = pool_columns((PoolId)pool, &columns)
		                   ? (size_t)lasting_items(world, pool_info[pool].per) * pool_info[pool].bytes
		                   : 0;
		largest = bytes > largest ? bytes : largest;
	}
	return largest;
}

// Clears values that are left over from earlier, so that equal worlds have equal snapshots.
static scree_status tidy(scree_world* world)
{
	const Step step = {0};
	Run runs[2 + CONSTRAINT_KINDS];
	int count = 0, bodies = lasting_items(world, PER_BODY), collidables = lasting_items(world, PER_COLLIDABLE);
#define TIDY(kernel, items) \
	if ((items) > 0)        \
		runs[count++] = (Run){.kernel_id = (kernel), .end = (items), .count = NO_COUNT};
	TIDY(KERNEL_body_tidy, bodies)
	TIDY(KERNEL_collidable_tidy, collidables)
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                \
	{                                                                                                    \
		int slots = lasting_items(world, PER_##KIND), places = lasting_items(world, PER_##KIND##_PLACE); \
		TIDY(KERNEL_##kind##_tidy, slots > places ? slots : places)                                      \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
#undef TIDY
	return count > 0 ? world_note(world, world->backend->f->run(world->backend, &step, runs, count)) : SCREE_OK;
}

scree_status snapshot_write(scree_world* world, const char* function, ChunkWriter* writer)
{
	TRY(world_upload(world));
	TRY(reports_fetch(world));
	// the end of a step changes some counters after the host has read them
	TRY(world_read(world, POOL_counters, 0, 1, &world->pipeline.counters));
	TRY(world_note(world, tree_upload(&world->pipeline))); // appends new leaves
	TRY(tidy(world));
	void* memory = world_scratch(world, largest_pool(world));
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a snapshot", function);
	TRY(chunks_begin(writer, function));
	host_write(writer, world);
	TRY(write_pools(writer, world, memory));
	return chunks_end(writer, function);
}
