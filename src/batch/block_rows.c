// SPDX-License-Identifier: MIT
// block_rows.c -- copies the states of single worlds of a block to rows, and checks rows.
#include "batch/block_rows.h"
#include "batch/block_gravity.h"
#include "batch/block_own.h"
#include "batch/block_places.h"
#include "batch/block_targets.h"
#include "batch/row_check.h"
#include "step/bay_layout.h"
#include "world/check.h"
#include <string.h>

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

// Copies the worlds of `count` copies to the spare bays, then to their rows.
static scree_status save_some(Staged* s, const int* copies, int count)
{
	Block* block = s->block;
	Backend* b = block->backend;
	s->count = count;
	for (int n = 0; n < count;)
	{
		int world = s->work->worlds[copies[n]];
		s->rows[n] = work_row(s->work, copies[n]);
		s->templates[n] = block_world_template(block, world);
		s->origins[n] = block_own_origin(block, block_row(block, world));
		block_add_copy(block, &n, block->bay_of[block_row(block, world)], block->stage + n, -1);
	}
	TRY(block_copy(block, count, 0));
	TRY(b->f->read(b, POOL_bay_state, block->stage, count, s->states));
	TRY(staged_read(s, POOL_pair, s->pair));
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
		TRY(staged_read(s, (PoolId)pool, s->items));
		write_items(s, (PoolId)pool);
	}
	TRY(staged_visits(s, true));
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

scree_status block_save(Block* block, const RowWork* work)
{
	int count;
	const int* copies = work_copies(block, work, &count);
	if (count == 0)
		return SCREE_OK;
	Staged staged;
	scree_status status = staged_open(&staged, block, work);
	for (int k = 0, part; k < count && status == SCREE_OK; k += part)
	{
		part = count - k < block->stages ? count - k : block->stages;
		status = save_some(&staged, copies + k, part);
	}
	staged_close(&staged);
	return status;
}

scree_status block_check(Block* block, const RowWork* work)
{
	int count;
	const int* copies = work_copies(block, work, &count);
	for (int k = 0; k < count; ++k)
	{
		RowHead head;
		int world = work->worlds[copies[k]], number = work->row_bytes ? copies[k] : 0, needed[ROW_KINDS];
		const Template* from = block_world_template(block, world);
		if (work->row_bytes == 0 && k > 0 && from == block_world_template(block, work->worlds[copies[k - 1]]))
			continue; // the same row was checked for the same template
		TRY(row_open(work_row(work, copies[k]), work->bytes, work->version, work->function, number, &head));
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
		int most = bays_slots_most(&block->pipeline.bays);
		if (head.count[ROW_CONTACTS] > most)
			return fail(SCREE_ERROR_INVALID,
			            "%s: state %d has %d slots for contacts, but worlds of the batch have at most %d",
			            work->function, number, head.count[ROW_CONTACTS], most);
		TRY(row_check(work_row(work, copies[k]), &head, from, work->function, number));
	}
	return SCREE_OK;
}
