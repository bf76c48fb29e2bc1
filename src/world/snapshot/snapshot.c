// SPDX-License-Identifier: MIT
// snapshot.c -- writes a world as a snapshot, and restores it on any device. A snapshot contains what a move to another
// device copies (world/device/migrate.c), and the data on the host. What depends on a device, such as the trees' nodes, the
// placement of chains and the groups of resting items, is computed again, and changes no bit.
#include "world/snapshot/snapshot.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"
#include "world/create.h"
#include "world/device/lasting.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/attributes.h"
#include "world/objects/collidables.h"
#include "world/objects/reports.h"
#include "world/pool_read.h"
#include "world/snapshot/host_check.h"
#include "world/snapshot/host_lists.h"
#include "world/snapshot/pool_check.h"
#include "world/snapshot/pool_columns.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <limits.h>
#include <string.h>

static const Column leaf_column[] = {{"each", COLUMN_EACH, 0, sizeof(int), 1}};
static const ColumnTable leaf_tables[2] = {COLUMN_TABLE("leaves0", leaf_column), COLUMN_TABLE("leaves1", leaf_column)};

// Returns the items of a pool, in memory of the backend or read into `memory`; null after a failure.
static const void* pool_items(scree_world* world, PoolId pool, int first, int count, void* memory)
{
	Backend* b = world->backend;
	char* there = b->f->address ? b->f->address(b, pool) : NULL;
	if (there)
		return there + (size_t)first * pool_info[pool].bytes;
	return world_note(world, b->f->read(b, pool, first, count, memory)) == SCREE_OK ? memory : NULL;
}

// Writes the leaves of a tree whose collidables are still in it, in their order.
static bool write_leaves(ChunkWriter* writer, scree_world* world, int t, int* memory)
{
	int count = world->pipeline.trees[t].tree.leaves, kept = 0;
	const int* leaves = pool_items(world, POOL_leaf, t * world->backend->capacity[PER_COLLIDABLE], count, memory);
	for (int k = 0; leaves && k < count; ++k)
	{
		int kind = collidable_kind(world, leaves[k]);
		if (kind != KIND_DEAD && tree_of_kind(kind) == t)
			memory[kept++] = leaves[k];
	}
	columns_write(writer, leaf_tables + t, memory, sizeof *memory, kept);
	return leaves;
}

static bool write_pools(ChunkWriter* writer, scree_world* world, void* memory)
{
	PoolColumns columns;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (!pool_columns((PoolId)pool, &columns))
			continue;
		int count = lasting_items(world, pool_info[pool].per);
		const void* items = count > 0 ? pool_items(world, (PoolId)pool, 0, count, memory) : memory;
		if (!items)
			return false;
		columns_write(writer, &columns.table, items, pool_info[pool].bytes, count);
	}
	return write_leaves(writer, world, 0, memory) && write_leaves(writer, world, 1, memory);
}

// Returns the size of the largest pool that a snapshot contains, or of the leaves, bytes.
static size_t largest_pool(const scree_world* world)
{
	PoolColumns columns;
	size_t largest = sizeof(int) * (size_t)world->collidables.capacity * 2 + 64;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t bytes = pool_columns((PoolId)pool, &columns)
		                   ? (size_t)lasting_items(world, pool_info[pool].per) * pool_info[pool].bytes
		                   : 0;
		largest = bytes > largest ? bytes : largest;
	}
	return largest;
}

scree_status snapshot_write(scree_world* world, const char* function, ChunkWriter* writer)
{
	TRY(world_upload(world));
	TRY(reports_fetch(world));
	// the end of a step changes some counters after the host has read them
	TRY(world_read(world, POOL_counters, 0, 1, &world->pipeline.counters));
	for (int t = 0; t < 2; ++t) // appends new leaves
		TRY(world_note(world, tree_upload(&world->pipeline)));
	void* memory = world_scratch(world, largest_pool(world));
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a snapshot", function);
	TRY(chunks_begin(writer, function));
	host_write(writer, world);
	if (!write_pools(writer, world, memory))
		return world->broken ? world->broken : SCREE_ERROR_DEVICE_FAILED;
	return chunks_end(writer, function);
}

typedef struct // a snapshot that is being restored
{
	ChunkIndex index;
	scree_world* made;       // the new world, without a device
	void* pools[POOL_COUNT]; // items of the pools
	int* leaves[2];          // collidables in the order of the leaves of each tree
	int leaf_count[2];
} Restore;

static void restore_close(Restore* r)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		scree_release(r->pools[pool]);
	scree_release(r->leaves[0]);
	scree_release(r->leaves[1]);
	chunks_close(&r->index);
	if (!r->made)
		return;
	r->made->backend = NULL;
	world_destroy(r->made);
}

static scree_status no_memory(const Restore* r)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to restore a snapshot", r->index.function);
}

static scree_status read_pools(Restore* r)
{
	PoolColumns columns;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (!pool_columns((PoolId)pool, &columns))
			continue;
		int count = lasting_items(r->made, pool_info[pool].per);
		size_t bytes = pool_info[pool].bytes;
		if (count < 0)
			return snapshot_refuse(&r->index, "pool %s has %d items", pool_info[pool].name, count);
		TRY(columns_check(&r->index, &columns.table, count));
		r->pools[pool] = scree_allocate((size_t)count * bytes + 1);
		if (!r->pools[pool])
			return no_memory(r);
		pool_inert((PoolId)pool, r->pools[pool], count);
		TRY(columns_read(&r->index, &columns.table, r->pools[pool], bytes, count));
	}
	return SCREE_OK;
}

// Reads the leaves of a tree. A collidable that is in no list is appended.
static scree_status read_leaves(Restore* r, int t, bool* listed)
{
	const scree_world* world = r->made;
	const Chunk* chunk = chunk_find(&r->index, t ? "leaves1.each" : "leaves0.each");
	int used = world->collidables.used, count = chunk ? chunk->count : 0;
	if (count > used)
		return snapshot_refuse(&r->index, "tree %d has %d leaves, and there are %d collidables", t, count, used);
	int* leaves = r->leaves[t] = scree_allocate((size_t)used * sizeof *leaves + 1);
	if (!leaves)
		return no_memory(r);
	TRY(columns_read(&r->index, leaf_tables + t, leaves, sizeof *leaves, count));
	for (int k = 0; k < count; ++k)
	{
		int leaf = leaves[k],
		    kind = leaf >= 0 && leaf < used && !listed[leaf] ? collidable_kind(world, leaf) : KIND_DEAD;
		if (kind == KIND_DEAD || tree_of_kind(kind) != t)
			return snapshot_refuse(&r->index, "leaf %d of tree %d is collidable %d", k, t, leaf);
		listed[leaf] = true;
	}
	for (int k = 0; k < used; ++k)
	{
		int kind = collidable_kind(world, k);
		if (kind != KIND_DEAD && tree_of_kind(kind) == t && !listed[k])
			leaves[count++] = k;
	}
	r->leaf_count[t] = count;
	return SCREE_OK;
}

static scree_status read_trees(Restore* r)
{
	TRY(tree_reserve(&r->made->pipeline, r->made->collidables.used));
	bool* listed = scree_allocate((size_t)r->made->collidables.used + 1);
	if (!listed)
		return no_memory(r);
	scree_status status = read_leaves(r, 0, listed);
	if (status == SCREE_OK)
		status = read_leaves(r, 1, listed);
	scree_release(listed);
	return status;
}

// Reads a snapshot into memory, and checks it. Changes no world.
static scree_status read_all(Restore* r, const void* bytes, size_t size)
{
	TRY(chunks_open(&r->index, r->index.function, bytes, size));
	r->made = scree_allocate(sizeof *r->made);
	if (!r->made)
		return no_memory(r);
	worlds_add(1);
	Backend without = {0}; // has room for any number of items, so that lasting_items counts those of the snapshot
	for (int per = 0; per < PER_COUNT; ++per)
		without.capacity[per] = INT_MAX;
	r->made->backend = &without;
	scree_status status = host_read(&r->index, r->made);
	if (status == SCREE_OK)
		status = host_check(&r->index, r->made);
	if (status == SCREE_OK)
		status = attributes_restore(r->made, r->index.function);
	if (status == SCREE_OK)
		status = read_pools(r);
	if (status == SCREE_OK)
		status = pool_check(&r->index, r->made, r->pools);
	if (status == SCREE_OK)
		status = read_trees(r);
	r->made->backend = NULL;
	return status;
}

// Enlarges the pools of the world for those of the snapshot.
static scree_status reserve(Restore* r, scree_world* world)
{
	Backend room = {0};
	for (int per = 0; per < PER_COUNT; ++per)
		room.capacity[per] = INT_MAX;
	for (int per = 0; per < PER_COUNT; ++per)
	{
		r->made->backend = &room;
		int count = lasting_items(r->made, (Per)per);
		r->made->backend = NULL;
		bool computed_again = per == PER_CHAIN || per == PER_BRANCH || per == PER_BODY_GROUP ||
		                      per == PER_COLLIDABLE_GROUP || per == PER_CONTACT_GROUP;
		if (count > 0 && !computed_again)
			TRY(pipeline_reserve(&world->pipeline, (Per)per, count + 1));
	}
	return SCREE_OK;
}

static scree_status write_items(Backend* b, PoolId pool, int count, const void* items)
{
	int capacity = b->capacity[pool_info[pool].per];
	if (count > 0)
		TRY(b->f->write(b, pool, 0, count, items));
	return capacity > count ? b->f->clear(b, pool, count, capacity - count) : SCREE_OK;
}

static scree_status write_samples(const scree_world* made, Backend* b)
{
	for (int k = 0; k < made->paths.used; ++k)
		if (slots_in_use(&made->paths, k))
			TRY(b->f->write(b, POOL_path_sample, made->host_paths[k].first, made->host_paths[k].segments + 1,
			                made->host_paths[k].samples));
	return SCREE_OK;
}

// Writes the pools to the device, and clears the rest of all pools that outlive a step.
static scree_status write_device(Restore* r, Backend* b)
{
	scree_world* made = r->made;
	made->backend = made->pipeline.backend = b;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int count = r->pools[pool] ? lasting_items(made, pool_info[pool].per) : 0;
		if (pool_info[pool].role != SCRATCH)
			TRY(write_items(b, (PoolId)pool, count, r->pools[pool]));
	}
	TRY(write_samples(made, b));
	TRY(b->f->write(b, POOL_counters, 0, 1, &made->pipeline.counters));
	for (int t = 0; t < 2; ++t)
		TRY(tree_restore_leaves(&made->pipeline, t, r->leaves[t], r->leaf_count[t]));
	pipeline_move(&made->pipeline, b);
	// this read also stores the counters in the backend, waits for the writes, and reports failed writes
	return b->f->read(b, POOL_counters, 0, 1, &made->pipeline.counters);
}

// Moves to the new world what belongs to the device and to the program, not to the snapshot.
static void adopt(scree_world* world, scree_world* made)
{
	scree_world_def def = world->def;
	const scree_world_def* saved = &made->def;
#define SAVED(member) def.member = saved->member
	SAVED(gravity), SAVED(contact_hertz), SAVED(contact_damping_ratio), SAVED(contact_push_speed);
	SAVED(restitution_threshold), SAVED(max_speed), SAVED(contact_limit), SAVED(contact_details);
	SAVED(hit_speed), SAVED(hit_impulse), SAVED(sleep), SAVED(sleep_threshold);
#undef SAVED
	made->def = def;
	made->opengl = world->opengl;
	made->auto_device = world->auto_device;
	memcpy(made->shared, world->shared, sizeof made->shared);
	memcpy(made->device, world->device, sizeof made->device);
	made->snapshot = world->snapshot;
	made->pipeline.first_contacts = world->pipeline.first_contacts;
	made->chains_stale = true;
	made->fields.stale = true;
	made->sensors.stale = true;
	made->reports.fetched = true;
	scree_world old = *world;
	*world = *made;
	*made = old;
	made->backend = NULL;
	made->auto_device = (AutoDevice){0};
	made->snapshot = (ChunkWriter){0};
}

static scree_status restore(Restore* r, scree_world* world, const void* bytes, size_t size)
{
	TRY(read_all(r, bytes, size));
	TRY(world_note(world, reserve(r, world)));
	scree_status status = write_device(r, world->backend);
	if (status == SCREE_OK)
		adopt(world, r->made);
	else
		world->broken = status;
	return status;
}

scree_status snapshot_restore(scree_world* world, const char* function, const void* bytes, size_t size)
{
	Restore r = {.index.function = function};
	scree_status status = restore(&r, world, bytes, size);
	restore_close(&r);
	return status;
}
