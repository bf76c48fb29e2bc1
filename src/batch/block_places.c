// SPDX-License-Identifier: MIT
// block_places.c -- moves worlds of a block to other bays: pauses, resumes and resets them.
//
// Running worlds are in the first bays, the live ones, so the time of a step depends only on their number. A paused world
// is in a spare bay. A bay that a paused world left gets a world that runs again, or the one from the last live bay.
#include "batch/block_places.h"
#include "batch/block_channels.h"
#include "batch/block_pools.h"
#include "batch/block_targets.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include <string.h>

scree_status block_places_open(Block* block)
{
	size_t worlds = (size_t)block->worlds;
	block->copies = scree_allocate(sizeof *block->copies * worlds);
	block->rows = scree_allocate(sizeof *block->rows * worlds);
	block->bay_of = scree_allocate(sizeof *block->bay_of * worlds);
	block->row_of = scree_allocate(sizeof *block->row_of * worlds);
	block->paused = scree_allocate(sizeof *block->paused * worlds);
	block->plan = scree_allocate(sizeof *block->plan * worlds);
	block->unused = scree_allocate(sizeof *block->unused * worlds);
	if (!block->copies || !block->rows || !block->bay_of || !block->row_of || !block->paused || !block->plan ||
	    !block->unused)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a batch");
	for (int k = 0; k < block->worlds; ++k)
		block->bay_of[k] = block->row_of[k] = k;
	return SCREE_OK;
}

void block_places_close(Block* block)
{
	scree_release(block->copies);
	scree_release(block->rows);
	scree_release(block->bay_of);
	scree_release(block->row_of);
	scree_release(block->paused);
	scree_release(block->plan);
	scree_release(block->unused);
}

scree_status block_copy(Block* block, int count, int contacts)
{
	const int most[] = {[CONSTRAINT_CONTACT] = contacts, [CONSTRAINT_JOINT] = block->pipeline.bay_joints};
	return bays_copy(&block->pipeline, block->copies, block->rows, count, most);
}

// Makes room for `leaving` more paused worlds.
static scree_status reserve_spares(Block* block, int leaving)
{
	int more = leaving - block->unused_count, first = block->empty + 1;
	if (more <= 0)
		return SCREE_OK;
	TRY(bays_spare(&block->pipeline, first + block->paused_most + more - block->worlds));
	for (int k = 0; k < more; ++k)
		block->unused[block->unused_count++] = first + block->paused_most++;
	return SCREE_OK;
}

// Moves worlds that are to be paused to spare bays.
static scree_status leave(Block* block)
{
	const Pipeline* p = &block->pipeline;
	int count = 0;
	for (int row = 0; row < block->worlds; ++row)
	{
		if (!(block->plan[row] & PLAN_PAUSE) || !block_runs(block, row))
			continue;
		int from = block->bay_of[row], to = block->unused[--block->unused_count];
		block->paused[row] = (Pending){.h = p->step.h,
		                               .dirty = p->dirty,
		                               .surfaces = p->surfaces_changed,
		                               .presses = p->counters.presses != 0,
		                               .taut = p->taut != 0,
		                               .lengths = p->lengths_vary};
		block_add_copy(block, &count, from, to, row);
		block->bay_of[row] = to;
		block->row_of[from] = -1;
	}
	return block_copy(block, count, 0);
}

static Pending template_pending(const Pipeline* from)
{
	// joints of the template that have not begun, or that have broken since, change the pairs that never touch
	return (Pending){.h = from->step.h,
	                 .dirty = from->dirty || from->can_break,
	                 .surfaces = from->surfaces_changed,
	                 .presses = from->counters.presses != 0,
	                 .taut = from->taut != 0};
}

void block_pend(Block* block, const Pending* pending)
{
	Pipeline* p = &block->pipeline;
	p->dirty |= pending->dirty;
	p->surfaces_changed |= pending->surfaces;
	p->counters.presses |= pending->presses; // Step.presses, in the next step
	p->taut |= pending->taut;
	p->lengths_vary |= pending->lengths || pending->h != p->step.h;
}

// Sets the flags of the next step that a world needs which runs again, or is put back to its template.
static void add_pending(Block* block, int row, bool resets)
{
	Pending pending = resets ? template_pending(&block_template(block, row)->pipeline) : block->paused[row];
	block_pend(block, &pending);
}

// Lists the rows of the worlds whose byte is not 0 in Block.rows, and returns their number. Without branches: which worlds are reset
// is random, so a processor would guess wrong for most of them. mask: null: all worlds.
static int list_masked(Block* block, const uint8_t* mask)
{
	const int *order = block->order->world, worlds = block->worlds, first = block->first;
	int *rows = block->rows, found = 0;
	for (int row = 0; row < worlds; ++row)
	{
		rows[found] = row;
		found += !mask || mask[order ? order[first + row] : first + row];
	}
	return found;
}

scree_status block_restore(Block* block, const uint8_t* mask, int* count)
{
	int found = list_masked(block, mask);
	// a loop of its own: the processor loads the values of many worlds at once, which are in different cache lines
	for (int k = 0, last = -1; k < found; ++k)
	{
		int row = block->rows[k], number = block_number(block, row);
		if (number != last)
			add_pending(block, row, true);
		last = number;
		block->copies[k] = make_int2(block->spare_of[number], block->bay_of[row]);
	}
	for (int k = 0; k < found && block->targets; ++k)
		block_targets_begin(block, block->rows[k]);
	*count = found;
	return block_copy(block, found, block->touching);
}

// Moves worlds to the first `live` bays, and puts worlds back to their templates.
static scree_status enter(Block* block, int live)
{
	int count = 0, free = 0, contacts = block->touching;
	for (int row = 0; row < block->worlds; ++row)
	{
		if (block->plan[row] & PLAN_PAUSE)
			continue;
		bool resets = block->plan[row] & PLAN_RESET, ran = block_runs(block, row);
		int from = block->bay_of[row], to = from;
		if (from >= live)
		{
			while (block->row_of[free] >= 0)
				++free;
			to = free;
		}
		if (resets || !ran)
			add_pending(block, row, resets);
		if (resets)
			block_targets_begin(block, row);
		if (!ran)
			block->unused[block->unused_count++] = from;
		else if (to != from)
			block->row_of[from] = -1;
		if (!resets && to != from)
			contacts = 1 << block->pipeline.bays.contact_bits;
		if (resets || to != from)
			block_add_copy(block, &count, resets ? block->spare_of[block_number(block, row)] : from, to, row);
		block->bay_of[row] = to;
		block->row_of[to] = row;
	}
	return block_copy(block, count, contacts);
}

// Empties bays from `live` on that were live before.
static scree_status vacate(Block* block, int live)
{
	int count = 0;
	for (int bay = live; bay < block->pipeline.live_bays; ++bay)
		block_add_copy(block, &count, block->empty, bay, -1);
	const int none[CONSTRAINT_KINDS] = {0};
	return bays_copy(&block->pipeline, block->copies, block->rows, count, none);
}

// Counts the touches of worlds that run again, so that the next outputs do not take them for new ones.
static scree_status count_touches(Block* block)
{
	int count = 0;
	for (int row = 0; row < block->worlds; ++row)
	{
		if (block->paused[row].uncounted && block_runs(block, row))
		{
			block_add_copy(block, &count, block->bay_of[row], block->bay_of[row], row);
			block->paused[row].uncounted = false;
		}
	}
	return block_begin_touches(block, count);
}

scree_status block_arrange(Block* block)
{
	int live = 0, leaving = 0;
	bool moves = false;
	for (int row = 0; row < block->worlds; ++row)
	{
		bool pauses = block->plan[row] & PLAN_PAUSE, runs = block_runs(block, row);
		live += !pauses;
		leaving += pauses && runs;
		moves |= pauses == runs;
	}
	TRY(reserve_spares(block, leaving));
	TRY(leave(block));
	TRY(enter(block, live));
	TRY(vacate(block, live));
	TRY(moves ? block_count(block, live) : SCREE_OK);
	return count_touches(block);
}
