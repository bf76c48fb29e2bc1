// SPDX-License-Identifier: MIT
// block_rows.c -- copies the states of single worlds of a block to rows, and back.
//
// States come and go through spare bays, whose items are adjacent: one read or write of each pool serves many worlds.
#include "batch/block_rows.h"
#include "batch/block_channels.h"
#include "batch/block_gravity.h"
#include "batch/block_own.h"
#include "batch/block_places.h"
#include "batch/block_targets.h"
#include "batch/own_host.h"
#include "batch/row_check.h"
#include "batch/world_row.h"
#include "pools/bays.h"
#include "step/bay_layout.h"
#include "world/check.h"
#include <string.h>

typedef struct // the states in the spare bays of a block
{
	Block* block;
	const RowWork* work;
	int count, copies;    // numbers of bays in use, and of copies from them
	char* items;          // items of one pool, of all these bays
	CollidablePair* pair; // pairs of collidables of their contacts
	BayState* states;
	Bay* bays;
	RowHead* heads;
	char** rows;
	const Template** templates;
	int* origins; // block_own_origin of the worlds that are saved
} Staged;

static const Template* template_of_world(const Block* block, int world)
{
	return block_template(block, block_row(block, world));
}

static int bay_items(const Bays* bays, int kind)
{
	const int items[ROW_KINDS] = {[ROW_BODIES] = bays->bodies,
	                              [ROW_COLLIDABLES] = bays->collidables,
	                              [ROW_CONTACTS] = 1 << bays->contact_bits,
	                              [ROW_JOINTS] = 1 << bays->joint_bits,
	                              [ROW_VISITS] = visit_size(bays->sensors, bays->collidables)};
	return items[kind];
}

size_t block_row_bytes(const Block* block)
{
	size_t most = 0;
	for (int k = 0; k < block->worlds; ++k)
	{
		int count[ROW_KINDS];
		const Template* from = block_template(block, k);
		if (k > 0 && from == block_template(block, k - 1))
			continue;
		row_count(from, 1 << block->pipeline.bays.contact_bits, count);
		size_t bytes = row_layout(count, NULL);
		most = bytes > most ? bytes : most;
	}
	return most;
}

static void close_staged(Staged* s)
{
	scree_release(s->items);
	scree_release(s->pair);
	scree_release(s->states);
	scree_release(s->bays);
	scree_release(s->heads);
	scree_release(s->rows);
	scree_release((void*)s->templates);
	scree_release(s->origins);
}

static scree_status open_staged(Staged* s, Block* block, const RowWork* work)
{
	const Bays* bays = &block->pipeline.bays;
	size_t bays_used = (size_t)block->stages;
	size_t most = sizeof(Word) * (size_t)bay_items(bays, ROW_VISITS);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = row_kind((PoolId)pool);
		size_t bytes = kind >= 0 ? pool_info[pool].bytes * (size_t)bay_items(bays, kind) : 0;
		most = bytes > most ? bytes : most;
	}
	*s = (Staged){.block = block, .work = work};
	s->items = scree_allocate(most * bays_used);
	s->pair = scree_allocate(sizeof *s->pair * bays_used << bays->contact_bits);
	s->states = scree_allocate(sizeof *s->states * bays_used);
	s->bays = scree_allocate(sizeof *s->bays * bays_used);
	s->heads = scree_allocate(sizeof *s->heads * bays_used);
	s->rows = scree_allocate(sizeof *s->rows * bays_used);
	s->templates = scree_allocate(sizeof *s->templates * bays_used);
	s->origins = scree_allocate(sizeof *s->origins * bays_used);
	if (s->items && s->pair && s->states && s->bays && s->heads && s->rows && s->templates && s->origins)
		return SCREE_OK;
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for the states of %d worlds", work->function, block->stages);
}

static char* row_of(const RowWork* work, int copy) { return work->rows + work->row_bytes * (size_t)copy; }

// Returns the first item of a pool in the spare bays, and sets *count to the number of items of a bay.
static int staged_items(const Staged* s, PoolId pool, int* count)
{
	const Bays* bays = &s->block->pipeline.bays;
	*count = bay_items(bays, row_kind(pool));
	return bay_item(bays->worlds, s->block->stage, 0, *count);
}

static scree_status read_staged(Staged* s, PoolId pool, void* items)
{
	Backend* b = s->block->backend;
	int count, first = staged_items(s, pool, &count);
	return b->f->read(b, pool, first, s->count * count, items);
}

static void write_head(Staged* s, int n, int world)
{
	const Block* block = s->block;
	const Pipeline* p = &block->pipeline;
	uint64_t targets = block_targets_of(block, block_row(block, world));
	RowHead* head = s->heads + n;
	int bits = p->bays.contact_bits;
	*head = (RowHead){.version = s->work->version,
	                  .fingerprint = s->templates[n]->fingerprint,
	                  .dt = p->step.dt,
	                  .state = s->states[n],
	                  .gravity = block_world_gravity(block, block_row(block, world)),
	                  .targets = targets,
	                  .target_hash = targets_hash(&s->templates[n]->targets, targets)};
	head->state.crowded = 0;
	row_count(s->templates[n], row_slots(s->pair + ((size_t)n << bits), 1 << bits), head->count);
}

// Copies the items of a pool to the rows.
static void write_items(Staged* s, PoolId pool)
{
	int kind = row_kind(pool), count;
	size_t at[POOL_COUNT], bytes = pool_info[pool].bytes;
	staged_items(s, pool, &count);
	for (int n = 0; n < s->count; ++n)
	{
		char* items = s->items + bytes * (size_t)(n * count);
		int used = s->heads[n].count[kind];
		if (kind == ROW_CONTACTS)
			row_tidy(pool, items, s->pair + ((size_t)n << s->block->pipeline.bays.contact_bits), used);
		row_shift(pool, items, used, -s->origins[n]);
		row_layout(s->heads[n].count, at);
		memcpy(s->rows[n] + at[pool], items, bytes * (size_t)used);
	}
}

// Copies the visits to sensors from the spare bays to the rows (saves), or from the rows to the spare bays.
static scree_status move_visits(Staged* s, bool saves)
{
	const Block* block = s->block;
	Backend* b = block->backend;
	const Bays* bays = &block->pipeline.bays;
	size_t at[POOL_COUNT];
	int size = bay_items(bays, ROW_VISITS), first = block->stage * size;
	if (size == 0)
		return SCREE_OK;
	if (saves)
		TRY(b->f->read(b, POOL_bay_visit, first, s->count * size, s->items));
	for (int n = 0; n < s->count; ++n)
	{
		Word* words = (Word*)(void*)s->items + (size_t)n * (size_t)size;
		const VisitBits* visits = &s->templates[n]->visits;
		row_layout(s->heads[n].count, at);
		if (saves)
			visits_take(bays, visits, words, s->rows[n] + at[POOL_bay_visit]);
		else
			visits_put(bays, visits, s->rows[n] + at[POOL_bay_visit], words);
	}
	return saves ? SCREE_OK : b->f->write(b, POOL_bay_visit, first, s->count * size, s->items);
}

// Copies the worlds of `count` copies to the spare bays, then to their rows.
static scree_status save_some(Staged* s, const int* copies, int count)
{
	Block* block = s->block;
	Backend* b = block->backend;
	s->count = count;
	for (int n = 0; n < count;)
	{
		int world = s->work->worlds[copies[n]];
		s->rows[n] = row_of(s->work, copies[n]);
		s->templates[n] = template_of_world(block, world);
		s->origins[n] = block_own_origin(block, block_row(block, world));
		block_add_copy(block, &n, block->bay_of[block_row(block, world)], block->stage + n, -1);
	}
	TRY(bays_copy(&block->pipeline, block->copies, block->rows, count));
	TRY(b->f->read(b, POOL_bay_state, block->stage, count, s->states));
	TRY(read_staged(s, POOL_pair, s->pair));
	for (int n = 0; n < count; ++n)
	{
		write_head(s, n, s->work->worlds[copies[n]]);
		memset(s->rows[n], 0, s->work->bytes);
	}
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = row_kind((PoolId)pool);
		if (kind < 0 || (kind == ROW_JOINTS && !block->pipeline.bay_joints))
			continue;
		TRY(read_staged(s, (PoolId)pool, s->items));
		write_items(s, (PoolId)pool);
	}
	TRY(move_visits(s, true));
	for (int n = 0; n < count; ++n)
	{
		const Template* from = s->templates[n];
		memcpy(s->rows[n] + row_own(s->heads[n].count),
		       block_own_values(block, block_row(block, s->work->worlds[copies[n]])), own_size(from));
		row_tidy_dead(s->rows[n], s->heads[n].count);
		row_seal(s->rows[n], s->heads + n);
	}
	return SCREE_OK;
}

static const int* copies_of(const Block* block, const RowWork* work, int* count)
{
	size_t k = (size_t)(block - work->blocks);
	*count = work->begin[k + 1] - work->begin[k];
	return work->order + work->begin[k];
}

scree_status block_save(Block* block, const RowWork* work)
{
	int count;
	const int* copies = copies_of(block, work, &count);
	if (count == 0)
		return SCREE_OK;
	Staged staged;
	scree_status status = open_staged(&staged, block, work);
	for (int k = 0, part; k < count && status == SCREE_OK; k += part)
	{
		part = count - k < block->stages ? count - k : block->stages;
		status = save_some(&staged, copies + k, part);
	}
	close_staged(&staged);
	return status;
}

scree_status block_check(Block* block, const RowWork* work)
{
	int count;
	const int* copies = copies_of(block, work, &count);
	for (int k = 0; k < count; ++k)
	{
		RowHead head;
		int world = work->worlds[copies[k]], number = work->row_bytes ? copies[k] : 0, needed[ROW_KINDS];
		const Template* from = template_of_world(block, world);
		if (work->row_bytes == 0 && k > 0 && from == template_of_world(block, work->worlds[copies[k - 1]]))
			continue; // the same row was checked for the same template
		TRY(row_open(row_of(work, copies[k]), work->bytes, work->version, work->function, number, &head));
		row_count(from, head.count[ROW_CONTACTS], needed);
		if (head.fingerprint != from->fingerprint || memcmp(needed, head.count, sizeof needed) != 0)
			return fail(SCREE_ERROR_INVALID,
			            "%s: state %d is that of a world with another structure or other settings than the template of "
			            "world %d",
			            work->function, number, world);
		if (head.targets & ~targets_all(&from->targets) ||
		    head.target_hash != targets_hash(&from->targets, head.targets))
			return fail(SCREE_ERROR_INVALID, "%s: state %d has pending targets that the template of world %d lacks",
			            work->function, number, world);
		if (head.count[ROW_CONTACTS] > block->pipeline.bay_limit)
			return fail(SCREE_ERROR_INVALID,
			            "%s: state %d has %d slots for contacts, but worlds of the batch have at most %d contacts",
			            work->function, number, head.count[ROW_CONTACTS], block->pipeline.bay_limit);
		TRY(row_check(row_of(work, copies[k]), &head, from, work->function, number));
	}
	return SCREE_OK;
}

// Copies the items of a pool from the rows to the spare bays.
static scree_status read_items(Staged* s, PoolId pool)
{
	Backend* b = s->block->backend;
	int kind = row_kind(pool), count, first = staged_items(s, pool, &count);
	size_t at[POOL_COUNT], bytes = pool_info[pool].bytes;
	for (int n = 0; n < s->count; ++n)
	{
		char* items = s->items + bytes * (size_t)(n * count);
		int used = s->heads[n].count[kind];
		row_layout(s->heads[n].count, at);
		memcpy(items, s->rows[n] + at[pool], bytes * (size_t)used);
		row_fill(pool, items + bytes * (size_t)used, count - used);
		row_shift(pool, items, used, s->templates[n]->first_attribute);
	}
	return b->f->write(b, pool, first, s->count * count, s->items);
}

// Notes what the next step of a world must do once.
static void note_pending(Block* block, const RowHead* head, int row)
{
	Pending pending = {.h = head->state.substep,
	                   .dirty = block->pipeline.bay_joints || block->pipeline.excluded > 0,
	                   .surfaces = head->state.surfaces != 0,
	                   .presses = head->state.presses != 0,
	                   .taut = head->state.taut_seen != 0};
	block_targets_set(block, row, head->targets);
	if (block_runs(block, row))
		block_pend(block, &pending);
	else
		block->paused[row] = pending;
}

// Writes the values of the worlds in the spare bays.
static scree_status write_values(Staged* s)
{
	const Block* block = s->block;
	Backend* b = block->backend;
	for (int n = 0; n < s->count; ++n)
	{
		const Template* from = s->templates[n];
		s->states[n] = s->heads[n].state;
		s->bays[n] = template_bay(from, (int)(from - block->templates));
	}
	TRY(b->f->write(b, POOL_bay, block->stage, s->count, s->bays));
	return b->f->write(b, POOL_bay_state, block->stage, s->count, s->states);
}

// Wakes the bodies of worlds whose gravity is not that of their states.
static scree_status wake(Staged* s)
{
	Block* block = s->block;
	if (!block->pipeline.sleeps)
		return SCREE_OK;
	scree_vec* before = scree_allocate(sizeof *before * (size_t)(s->copies + 1));
	if (!before)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to wake %d worlds", s->work->function, s->copies);
	for (int k = 0; k < s->copies; ++k)
		before[k] = s->heads[block->copies[k].x - block->stage].gravity;
	scree_status status = block_wake(block, block->rows, before, s->copies);
	scree_release(before);
	return status;
}

// Copies the states from the rows to the spare bays, then to the worlds.
static scree_status load_some(Staged* s)
{
	Block* block = s->block;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		int kind = row_kind((PoolId)pool);
		if (kind >= 0 && (kind != ROW_JOINTS || block->pipeline.bay_joints))
			TRY(read_items(s, (PoolId)pool));
	}
	for (int k = 0; k < s->copies; ++k)
		note_pending(block, s->heads + (block->copies[k].x - block->stage), block->rows[k]);
	TRY(move_visits(s, false));
	TRY(write_values(s));
	TRY(bays_copy(&block->pipeline, block->copies, block->rows, s->copies));
	TRY(wake(s));
	for (int k = 0; k < s->copies; ++k)
	{
		int n = block->copies[k].x - block->stage;
		TRY(block_own_take(block, block->rows[k], s->rows[n] + row_own(s->heads[n].count)));
	}
	TRY(block_own_send(block));
	TRY(block_begin_touches(block, s->copies));
	s->count = s->copies = 0;
	return SCREE_OK;
}

// Adds a copy. Copies of the same row to worlds of the same template share a spare bay.
static scree_status add_copy(Staged* s, char* row, int world)
{
	Block* block = s->block;
	const Template* from = template_of_world(block, world);
	int last = s->count - 1;
	if (last < 0 || s->rows[last] != row || s->templates[last] != from)
	{
		if (s->count == block->stages)
			TRY(load_some(s));
		s->rows[s->count] = row;
		s->templates[s->count] = from;
		memcpy(s->heads + s->count, row, sizeof *s->heads);
		++s->count;
	}
	int row_of_world = block_row(block, world);
	block_add_copy(block, &s->copies, block->stage + s->count - 1, block->bay_of[row_of_world], row_of_world);
	return SCREE_OK;
}

static scree_status grow(Block* block, const RowWork* work, const int* copies, int count)
{
	int most = 0;
	for (int k = 0; k < count; ++k)
	{
		RowHead head;
		memcpy(&head, row_of(work, copies[k]), sizeof head);
		most = head.count[ROW_CONTACTS] > most ? head.count[ROW_CONTACTS] : most;
	}
	return bays_fit(&block->pipeline, most);
}

scree_status block_load(Block* block, const RowWork* work)
{
	int count;
	const int* copies = copies_of(block, work, &count);
	if (count == 0)
		return SCREE_OK;
	TRY(grow(block, work, copies, count));
	Staged staged;
	scree_status status = open_staged(&staged, block, work);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
		status = add_copy(&staged, row_of(work, copies[k]), work->worlds[copies[k]]);
	if (status == SCREE_OK)
		status = load_some(&staged);
	close_staged(&staged);
	return status;
}
