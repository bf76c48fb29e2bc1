// SPDX-License-Identifier: MIT
// migrate.c -- moves a world from one device to another, between two steps. Only the pools whose items outlive a step
// are copied. In the host's data, only positions in trees and chains depend on the device; they are computed again.
#include "world/device/migrate.h"
#include "platform/error.h"
#include "world/device/idle.h"
#include "world/device/lasting.h"
#include "world/device/shared_buffers.h"
#include "world/failure.h"
#include "world/world.h"
#include <stdio.h>
#include <string.h>

#define BOUNCE_BYTES ((size_t)4 << 20) // size of a buffer, used if the host can address the pools of neither device

static int smaller(int a, int b) { return a < b ? a : b; }

typedef struct // a move in progress
{
	scree_world* world;
	Backend* to;
	char* bounce;
} Move;

static scree_status fetch(Move* m, PoolId pool, int first, int count, void* items)
{
	Backend* from = m->world->backend;
	return world_note(m->world, from->f->read(from, pool, first, count, items));
}

static scree_status copy(Move* m, PoolId pool, int first, int to_first, int count)
{
	Backend* to = m->to;
	void *here = pool_item_address(m->world->backend, pool, first), *there = pool_item_address(to, pool, to_first);
	if (here)
		return to->f->write(to, pool, to_first, count, here);
	if (there)
		return fetch(m, pool, first, count, there);
	if (!m->bounce)
		m->bounce = scree_allocate(BOUNCE_BYTES);
	if (!m->bounce)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to move a world");
	int most = (int)(BOUNCE_BYTES / pool_info[pool].bytes);
	for (int k = 0; k < count; k += most)
	{
		int part = smaller(most, count - k);
		TRY(fetch(m, pool, first + k, part, m->bounce));
		TRY(to->f->write(to, pool, to_first + k, part, m->bounce));
	}
	return SCREE_OK;
}

static scree_status copy_all(Move* m)
{
	const scree_world* world = m->world;
	Backend *from = world->backend, *to = m->to;
	for (int per = 0; per < PER_COUNT; ++per)
		if (from->capacity[per] > to->capacity[per])
			TRY(to->f->resize(to, (Per)per, from->capacity[per]));
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		if (pool_info[pool].role <= STANDING)
			TRY(copy(m, (PoolId)pool, 0, 0, lasting_items(world, pool_info[pool].per)));
	for (int t = 0; t < 2; ++t)
		TRY(copy(m, POOL_leaf, t * from->capacity[PER_COLLIDABLE], t * to->capacity[PER_COLLIDABLE],
		         world->pipeline.trees[t].tree.leaves));

	TRY(to->f->clear(to, POOL_start_pose, 0, to->capacity[PER_BODY]));

	// this read also stores the counters in the backend, waits for the writes, and reports failed writes
	Counters counters;
	return to->f->read(to, POOL_counters, 0, 1, &counters);
}

scree_status world_move(scree_world* world, Backend* to)
{
	Move m = {.world = world, .to = to};
	scree_status status = copy_all(&m);
	scree_release(m.bounce);
	if (status != SCREE_OK)
		return status;
	world_unshare(world);       // another device cannot use the shared memory
	world->chains_stale = true; // the placement of chains depends on the device
	world->fields.stale = true; // fields are not copied, but uploaded again
	idle_forget(world);
	world->backend = to;
	snprintf(world->device, sizeof world->device, "%s", to->name);
	pipeline_move(&world->pipeline, to);
	return SCREE_OK;
}
