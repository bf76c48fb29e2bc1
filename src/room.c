// SPDX-License-Identifier: MIT
// room.c -- how much room the pools have: made when a stage found too little, given back when most of it was long idle.
#include "tree.h"
#include "world.h"
#include <math.h>

// Room is given back when for so many steps, 2 s of a game, never more than an eighth of it was used; twice what was used
// stays. So a burst that comes again within that time finds its room, and a pool that has shrunk must fill up fourfold
// before it grows to what it was.
#define IDLE_STEPS 120
#define IDLE_SHARE 4 // of capacity, against twice the use

// Contacts are moved together when for so many steps fewer than a quarter of the slots were in use: each step looks at
// all slots, and a pool cannot shrink below the last one. It changes the names of contacts, and so bits: it may depend on
// nothing but counts that are the same on every device. Small worlds, where nothing is to be won, keep their slots.
#define SPARSE_STEPS 60
#define SPARSE_SHARE 4
#define SPARSE_SLOTS 4096

#define LEAST_ROOM 64

static int64_t rounded(int64_t capacity) { return (capacity + LEAST_ROOM - 1) / LEAST_ROOM * LEAST_ROOM; }

// every color may need padding
static int64_t constraints_of(int64_t contacts) { return contacts + (COLORS + 1) * COLOR_PADDING; }

static int larger(int a, int b) { return a > b ? a : b; }

static int first_contacts(const scree_world* world)
{
	return world->def.contact_capacity > 0 ? world->def.contact_capacity + 1 : 512;
}

static void note(Pipeline* pipeline, Per per, int used) { pipeline->used[per] = larger(pipeline->used[per], used); }

static scree_status resize(scree_world* world, Per per, int64_t capacity)
{
	Backend* b = world->backend;
	if (capacity <= b->capacity[per])
		return SCREE_OK;
	if (capacity > INT32_MAX / 2)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "a pool of %lld items is beyond what an index can name",
		            (long long)capacity);
	return b->f->resize(b, per, (int)capacity);
}

scree_status pipeline_reserve(scree_world* world, Per per, int capacity)
{
	Backend* b = world->backend;
	int old = b->capacity[per];
	note(&world->pipeline, per, capacity);
	if (capacity <= old)
		return SCREE_OK;
	int64_t wanted = rounded(capacity > old + old / 2 ? capacity : (int64_t)old + old / 2);
	world->pipeline.grown += old > 0;

	scree_status status = SCREE_OK;
	int* leaves = NULL;
	if (per == CONTACT)
	{
		status = resize(world, CONSTRAINT, constraints_of(wanted));
		if (!status)
			status = resize(world, BLOCK, constraints_of(wanted) / MAX_LANES);
		if (!status)
			status = resize(world, KEY, wanted);
	}
	if (per == CONSTRAINT)
		status = resize(world, BLOCK, wanted / MAX_LANES);
	if (per == COLLIDABLE)
	{
		status = tree_save(world, &leaves);
		if (!status)
			status = resize(world, LEAF, 2 * wanted);
		if (!status)
			status = resize(world, NODE, 2 * (int64_t)tree_nodes((int)wanted));
		if (!status)
			status = resize(world, KEY, wanted);
	}
	if (!status)
		status = resize(world, per, wanted);
	if (!status && per == COLLIDABLE)
		status = tree_restore(world, leaves);
	scree_release(leaves);
	return status;
}

scree_status pipeline_open(scree_world* world)
{
	int bodies = world->def.body_capacity;
	world->pipeline.guard_way = INFINITY;
	scree_status status = pipeline_reserve(world, ONE, 1);
	if (!status)
		status = pipeline_reserve(world, HASH, HASH_SUMS);
	if (!status)
		status = pipeline_reserve(world, TREE, 2);
	if (!status)
		status = pipeline_reserve(world, ATTRIBUTE, 16);
	if (!status)
		status = pipeline_reserve(world, BODY, bodies > 0 ? bodies + 1 : 256);
	if (!status)
		status = pipeline_reserve(world, COLLIDABLE, bodies > 0 ? bodies : 256);
	if (!status)
		status = pipeline_reserve(world, CONTACT, first_contacts(world));
	if (!status)
		status = pipeline_reserve(world, COMMAND, LEAST_ROOM);
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// giving back
// ---------------------------------------------------------------------------------------------------------------

// Gives a kind of pool as much room as twice its use, if that is much less than it has. Whether it has done so: what has
// no memory to become smaller stays as large as it is, and no harm is done.
static bool shrink(scree_world* world, Per per, int least)
{
	Backend* b = world->backend;
	int64_t wanted = rounded(larger(2 * world->pipeline.used[per], least));
	return wanted * IDLE_SHARE < b->capacity[per] && b->f->resize(b, per, (int)wanted) == SCREE_OK;
}

static void shrink_all(scree_world* world)
{
	Backend* b = world->backend;
	int contacts = first_contacts(world);
	shrink(world, CONTACT, contacts);
	if (shrink(world, CONSTRAINT, (int)constraints_of(b->capacity[CONTACT])))
		b->f->resize(b, BLOCK, b->capacity[CONSTRAINT] / MAX_LANES);
	shrink(world, KEY, larger(b->capacity[CONTACT], b->capacity[COLLIDABLE]));
	shrink(world, SPOKE, LEAST_ROOM);
	shrink(world, SPOKE_BLOCK, LEAST_ROOM);
	shrink(world, COMMAND, LEAST_ROOM);
}

bool pipeline_sparse(scree_world* world)
{
	Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	int64_t alive = c->alive - c->released;
	pipeline->sparse = c->contacts > SPARSE_SHARE * alive + SPARSE_SLOTS ? pipeline->sparse + 1 : 0;
	return pipeline->sparse >= SPARSE_STEPS;
}

void pipeline_trim(scree_world* world)
{
	Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	note(pipeline, CONTACT, c->contacts + 1);
	note(pipeline, CONSTRAINT, c->color_begin[COLORS + 1]);
	note(pipeline, SPOKE, pipeline_spokes(c));
	note(pipeline, SPOKE_BLOCK, pipeline_spokes(c) / MAX_LANES);
	note(pipeline, KEY, larger(c->pairs, pipeline_spokes(c)));
	if (++pipeline->idle < IDLE_STEPS)
		return;
	shrink_all(world);
	pipeline->idle = 0;
	for (int per = 0; per < PER_COUNT; ++per)
		pipeline->used[per] = 0;
}
