// SPDX-License-Identifier: MIT
// restore.c -- restores a world from a snapshot, on any device. What depends on a device, such as the trees' nodes, the
// placement of chains and the groups of resting items, is computed again, and changes no bit.
#include "world/snapshot/restore.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"
#include "world/create.h"
#include "world/device/lasting.h"
#include "world/failure.h"
#include "world/objects/attributes.h"
#include "world/objects/collidables.h"
#include "world/snapshot/host_check.h"
#include "world/snapshot/host_lists.h"
#include "world/snapshot/pool_check.h"
#include "world/snapshot/pool_columns.h"
#include "world/snapshot/reported.h"
#include "world/structure.h"
#include "world/upload/upload.h"
#include <limits.h>
#include <string.h>

typedef struct // a snapshot that is being restored
{
	ChunkIndex index;
	scree_world* made;       // the new world
	Backend room;            // the backend of `made` until it gets a device: pools have room for any number of items
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
		columns_read(&r->index, &columns.table, r->pools[pool], bytes, count);
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
	TRY(columns_check(&r->index, leaf_tables + t, count));
	columns_read(&r->index, leaf_tables + t, leaves, sizeof *leaves, count);
	for (int k = 0; k < count; ++k)
	{
		int leaf = leaves[k],
		    kind = leaf >= 0 && leaf < used && !listed[leaf] ? collidable_kind(world, leaf) : KIND_DEAD;
		if (kind == KIND_DEAD || tree_of_kind(kind) != t)
			return snapshot_refuse(&r->index, "leaf %d of tree %d is collidable %d", k, t, leaf);
		listed[leaf] = true;
	}
	for (int k = 0; k < used; ++k)
		if (!listed[k] && collidable_in_tree(world, k, t))
			leaves[count++] = k;
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

// Reads a snapshot into memory, and checks it. def: definition of the world that it will replace.
static scree_status read_all(Restore* r, const scree_world_def* def, const void* bytes, size_t size)
{
	TRY(chunks_open(&r->index, r->index.function, bytes, size));
	r->made = scree_allocate(sizeof *r->made);
	if (!r->made)
		return no_memory(r);
	worlds_add(1);
	for (int per = 0; per < PER_COUNT; ++per)
		r->room.capacity[per] = INT_MAX;
	r->made->backend = &r->room;
	r->made->def = *def; // the snapshot has other values of some members
	TRY(host_read(&r->index, r->made));
	TRY(host_check(&r->index, r->made));
	TRY(attributes_restore(r->made, r->index.function));
	TRY(read_pools(r));
	TRY(pool_check(&r->index, r->made, r->pools));
	return read_trees(r);
}

// Enlarges the pools of the world for those of the snapshot.
static scree_status reserve(Restore* r, scree_world* world)
{
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		Per per = pool_info[pool].per;
		int count = r->pools[pool] || pool == POOL_path_sample ? lasting_items(r->made, per) : 0;
		if (count > 0)
			TRY(pipeline_reserve(&world->pipeline, per, count + 1));
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
		if (pool_info[pool].role != SCRATCH && pool_info[pool].per != PER_SAVED)
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
	made->opengl = world->opengl;
	made->tasks = world->tasks;
	made->readers = world->readers;
	made->auto_device = world->auto_device;
	memcpy(made->shared, world->shared, sizeof made->shared);
	memcpy(made->device, world->device, sizeof made->device);
	made->snapshot = world->snapshot;
	made->recorders = world->recorders;
	made->saves = world->saves;
	made->recovery = world->recovery;
	structure_changed(made);
	made->pipeline.first_contacts = world->pipeline.first_contacts;
	made->chains_stale = true;
	made->fields.stale = true;
	made->sensors.stale = true;
	made->reports.fetched = true;
	scree_world old = *world;
	*world = *made;
	*made = old;
	made->backend = NULL;
	made->readers = NULL;
	made->auto_device = (AutoDevice){0};
	made->snapshot = (ChunkWriter){0};
	made->recorders = (Recorders){0};
	made->saves = (Saves){0};
	made->recovery = NULL;
}

static scree_status restore(Restore* r, scree_world* world, const void* bytes, size_t size)
{
	TRY(read_all(r, &world->def, bytes, size));
#ifndef SCREE_SMALL // a build for WebAssembly shares no memory
	float unit = r->made->def.length_unit;
	for (int use = 0; use < SHARED_USES && unit != 0.0f; ++use)
		if (world->shared[use] > 0)
			return fail(SCREE_ERROR_NOT_SUPPORTED,
			            "%s: the world shares memory in metres, and the length_unit of the snapshot is %g",
			            r->index.function, (double)unit);
#endif
	TRY(world_upload(world)); // so that the slots of bodies are those of the device
	TRY(world_note(world, reported_keep(world, r->made, r->pools[POOL_reported_pose], r->pools[POOL_reported_sleep])));
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
