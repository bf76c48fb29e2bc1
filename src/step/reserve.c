// SPDX-License-Identifier: MIT
// reserve.c -- sets the capacities of the pools: enlarges them for a stage, and shrinks those that remain too large.
#include "step/reserve.h"
#include "backend/solve_runs.h"
#include "platform/error.h"
#include "step/tree_maintenance.h"

// If less than an eighth of a pool was used in IDLE_STEPS steps (2 s at 60 Hz), the pool shrinks to twice the used
// size. So a burst that repeats within that time causes no growth. The pool grows again when its use has doubled.
#define IDLE_STEPS 120
#define IDLE_SHARE 4 // a pool shrinks if twice its used size is less than 1 / IDLE_SHARE of its capacity

// Contacts are packed if fewer than a quarter of their slots were used for SPARSE_STEPS steps. Otherwise each step
// would visit all slots, and the pool could not shrink below the last contact. Packing changes the indices of contacts,
// and therefore the world hash, so the decision depends only on counts that are equal on every device.
#define SPARSE_STEPS 60
#define SPARSE_SHARE 4
#define SPARSE_SLOTS 4096 // with at most this number of slots, packing would save nothing

// A pool grows by at least half of its size, in a batch by 1 / GROWTH_OF_BATCH of it: the worlds of a batch are known when its
// pools are made, so growth is rare.
#define GROWTH_OF_BATCH 4

const Per grouped[GROUP_KINDS] = {PER_BODY, PER_COLLIDABLE, PER_CONTACT};
static const Per groups[GROUP_KINDS] = {PER_BODY_GROUP, PER_COLLIDABLE_GROUP, PER_CONTACT_GROUP};

static int64_t rounded(int64_t capacity) { return (capacity + LEAST_CAPACITY - 1) / LEAST_CAPACITY * LEAST_CAPACITY; }

int64_t places_of(int64_t constraints) { return constraints + (COLORS + 1) * COLOR_PADDING; }

static int larger(int a, int b) { return a > b ? a : b; }

static void note(Pipeline* pipeline, Per per, int used) { pipeline->used[per] = larger(pipeline->used[per], used); }

static scree_status resize(Pipeline* pipeline, Per per, int64_t capacity)
{
	Backend* b = pipeline->backend;
	if (capacity <= b->capacity[per])
		return SCREE_OK;
	if (capacity > INT32_MAX / 2)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "a pool of %lld items is beyond what an index can name",
		            (long long)capacity);
	return b->f->resize(b, per, (int)capacity);
}

static int edges(const Backend* b)
{
	int sum = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		sum += b->capacity[kind_info[kind].items];
	return sum;
}

static scree_status reserve_kind(Pipeline* pipeline, const KindInfo* kind, Per per, int64_t wanted)
{
	const Backend* b = pipeline->backend;
	if (per == kind->places)
		return resize(pipeline, kind->blocks, wanted / MAX_LANES);
	if (per != kind->items)
		return SCREE_OK;
	if (!OF_BATCH(pipeline)) // most slots of bays are free, so a batch reserves places for the constraints that exist
	{
		TRY(resize(pipeline, kind->places, places_of(wanted)));
		TRY(resize(pipeline, kind->blocks, places_of(wanted) / MAX_LANES));
	}
	TRY(resize(pipeline, PER_EDGE, edges(b) - b->capacity[per] + wanted));
	return resize(pipeline, PER_KEY, b->capacity[PER_EDGE]);
}

int groups_most(const Backend* b) { return larger(b->capacity[PER_BODY], b->capacity[PER_COLLIDABLE]) / GROUP_ITEMS; }

scree_status pipeline_reserve(Pipeline* pipeline, Per per, int capacity)
{
	Backend* b = pipeline->backend;
	int old = b->capacity[per];
	note(pipeline, per, capacity);
	if (capacity <= old)
		return SCREE_OK;
	int64_t more = OF_BATCH(pipeline) ? old / GROWTH_OF_BATCH : old / 2;
	int64_t wanted = rounded(capacity > old + more ? capacity : old + more);
	pipeline->grown += old > 0 && per != PER_SAVED; // saves change no state

	scree_status status = SCREE_OK;
	int* leaves = NULL;
	for (int kind = 0; kind < CONSTRAINT_KINDS && !status; ++kind)
		status = reserve_kind(pipeline, &kind_info[kind], per, wanted);
	if (per == PER_COLLIDABLE)
	{
		int trees = OF_BATCH(pipeline) ? 1 : 2; // the tree of static collidables of a batch is empty
		status = tree_save(pipeline, &leaves);
		if (!status)
			status = resize(pipeline, PER_LEAF, trees * wanted);
		if (!status)
			status = resize(pipeline, PER_NODE, trees * (int64_t)tree_nodes((int)wanted));
		if (!status)
			status = resize(pipeline, PER_NODE_GROUP, b->capacity[PER_NODE] / ARITY);
		if (!status)
			status = resize(pipeline, PER_KEY, wanted);
	}
	for (int kind = 0; kind < GROUP_KINDS && !status; ++kind)
		if (per == grouped[kind])
			status = resize(pipeline, groups[kind], wanted / GROUP_ITEMS);
	if (!status && per == PER_CONTACT && pipeline->reports)
		status = resize(pipeline, PER_EVENT, wanted);
	if (!status && per == PER_CONTACT && (pipeline->asks || pipeline->platforms))
		status = resize(pipeline, PER_APPROVAL, wanted);
	if (!status)
		status = resize(pipeline, per, wanted);
	if (!status && per == PER_COLLIDABLE)
		status = tree_restore(pipeline, leaves);
	scree_release(leaves);
	return status;
}

// Shrinks pools, unless memory for the copy is lacking; then they stay large.
static scree_status shrink_to(Backend* b, Per per, int capacity)
{
	scree_status status = b->f->resize(b, per, capacity);
	return status == SCREE_ERROR_OUT_OF_MEMORY ? SCREE_OK : status;
}

// Shrinks much larger pools to twice their used size, but at least to `least` items.
static scree_status shrink(Pipeline* pipeline, Per per, int least)
{
	Backend* b = pipeline->backend;
	int64_t wanted = rounded(larger(2 * pipeline->used[per], least));
	return wanted * IDLE_SHARE < b->capacity[per] ? shrink_to(b, per, (int)wanted) : SCREE_OK;
}

static scree_status shrink_all(Pipeline* pipeline)
{
	Backend* b = pipeline->backend;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		const KindInfo* info = &kind_info[kind];
		int items = b->capacity[info->items], places = b->capacity[info->places];
		TRY(shrink(pipeline, info->items, kind == CONSTRAINT_CONTACT ? pipeline->first_contacts : LEAST_CAPACITY));
		if (b->capacity[info->items] < items)
			TRY(shrink_to(b, PER_EDGE, edges(b)));
		TRY(shrink(pipeline, info->places, (int)places_of(b->capacity[info->items])));
		if (b->capacity[info->places] < places)
			TRY(shrink_to(b, info->blocks, b->capacity[info->places] / MAX_LANES));
	}
	// color_rank: a key per edge
	TRY(shrink(pipeline, PER_KEY, larger(b->capacity[PER_EDGE], b->capacity[PER_COLLIDABLE])));
	static const Per others[] = {PER_SPOKE, PER_SPOKE_BLOCK, PER_COMMAND, PER_QUERY, PER_FOUND};
	for (size_t k = 0; k < sizeof others / sizeof *others; ++k)
		TRY(shrink(pipeline, others[k], LEAST_CAPACITY));
	return SCREE_OK;
}

bool pipeline_sparse(Pipeline* pipeline)
{
	const Counters* c = &pipeline->counters;
	int64_t alive = c->alive - c->released;
	if (OF_BATCH(pipeline)) // slots of a bay are never packed
		return false;
	pipeline->sparse = c->contacts > SPARSE_SHARE * alive + SPARSE_SLOTS ? pipeline->sparse + 1 : 0;
	return pipeline->sparse >= SPARSE_STEPS;
}

scree_status pipeline_trim(Pipeline* pipeline)
{
	const Counters* c = &pipeline->counters;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		note(pipeline, kind_info[kind].items, kind_items(c, kind) + 1);
		note(pipeline, kind_info[kind].places, c->layout[kind].begin[COLORS + 1]);
	}
	note(pipeline, PER_SPOKE, layout_spokes(c));
	note(pipeline, PER_SPOKE_BLOCK, layout_spokes(c) / MAX_LANES);
	note(pipeline, PER_KEY, larger(c->pairs, layout_spokes(c)));
	if (++pipeline->idle < IDLE_STEPS || OF_BATCH(pipeline))
		return SCREE_OK;
	TRY(shrink_all(pipeline));
	pipeline->idle = 0;
	for (int per = 0; per < PER_COUNT; ++per)
		pipeline->used[per] = 0;
	return SCREE_OK;
}
