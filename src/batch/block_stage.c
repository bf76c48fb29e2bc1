// SPDX-License-Identifier: MIT
// block_stage.c -- the spare bays of a block through which the states of worlds come and go.
#include "batch/block_stage.h"
#include "platform/error.h"
#include "pools/bays.h"

char* work_row(const RowWork* work, int copy) { return work->rows + work->row_bytes * (size_t)copy; }

const int* work_copies(const Block* block, const RowWork* work, int* count)
{
	size_t k = (size_t)(block - work->blocks);
	*count = work->begin[k + 1] - work->begin[k];
	return work->order + work->begin[k];
}

const Template* block_world_template(const Block* block, int world)
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

void staged_close(Staged* s)
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

scree_status staged_open(Staged* s, Block* block, const RowWork* work)
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

int staged_items(const Staged* s, PoolId pool, int* count)
{
	const Bays* bays = &s->block->pipeline.bays;
	*count = bay_items(bays, row_kind(pool));
	return bay_item(bays->worlds, s->block->stage, 0, *count);
}

scree_status staged_read(Staged* s, PoolId pool, void* items)
{
	Backend* b = s->block->backend;
	int count, first = staged_items(s, pool, &count);
	return b->f->read(b, pool, first, s->count * count, items);
}

scree_status staged_visits(Staged* s, bool saves)
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
