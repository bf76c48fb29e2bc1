// SPDX-License-Identifier: MIT
// block_load.c -- puts worlds of a block into the states of rows.
#include "batch/block_load.h"
#include "batch/block_channels.h"
#include "batch/block_gravity.h"
#include "batch/block_own.h"
#include "batch/block_places.h"
#include "batch/block_targets.h"
#include "step/bay_layout.h"
#include <string.h>

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
	                   .taut = head->state.taut_seen != 0,
	                   .uncounted = true};
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
	TRY(staged_visits(s, false));
	TRY(write_values(s));
	TRY(block_copy(block, s->copies, 1 << block->pipeline.bays.contact_bits));
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
	const Template* from = block_world_template(block, world);
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
		memcpy(&head, work_row(work, copies[k]), sizeof head);
		most = head.count[ROW_CONTACTS] > most ? head.count[ROW_CONTACTS] : most;
	}
	return bays_fit(&block->pipeline, most);
}

scree_status block_load(Block* block, const RowWork* work)
{
	int count;
	const int* copies = work_copies(block, work, &count);
	if (count == 0)
		return SCREE_OK;
	TRY(grow(block, work, copies, count));
	Staged staged;
	scree_status status = staged_open(&staged, block, work);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
		status = add_copy(&staged, work_row(work, copies[k]), work->worlds[copies[k]]);
	if (status == SCREE_OK)
		status = load_some(&staged);
	staged_close(&staged);
	return status;
}
