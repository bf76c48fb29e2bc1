// SPDX-License-Identifier: MIT
// work.c -- lists of runs on the CPU: each run by all workers, or by one.
//
// A list of runs is executed in one parallel region, with a barrier after each shared run. Worker 0, when all have arrived
// at the barrier, reads the bound of the next run, does small runs by itself, and releases the others at the next run
// that is worth sharing. So a bound is read once, by one worker, while no worker writes it, and a small world never
// wakes a thread.
#include "cpu/cpu.h"
#include "platform/processor.h"
#include <limits.h>

// A run whose items take long is worth sharing from fewer items on: an item of a stage in chunks counts as so many.
#define CHUNK_ITEM 8
// instead of the items per chunk: items are dealt (src/backend/backend.h)
#define DEALT (-1)
// fewest items for which a sort and a scan are shared
#define SORT_GRAIN 8192
#define SCAN_GRAIN 16384

// Items per chunk. A stage whose items take long, and unequal times, is handed out in chunks to workers that are free. The
// other stages are split evenly and in order, so that a worker has the same bodies and constraints in every pass.
static const int chunks[STAGE_COUNT] = {
    [STAGE_broad_phase] = CHUNK_ITEMS,
    [STAGE_broad_phase_rest] = 1,
    [STAGE_narrow_phase] = CHUNK_ITEMS,
    [STAGE_query_ray] = CHUNK_ITEMS,
    [STAGE_query_shape] = CHUNK_ITEMS,
    [STAGE_query_nearest] = CHUNK_ITEMS,
    [STAGE_sense] = 1,
    [STAGE_hub] = 1,
    [STAGE_chain_begin] = DEALT,
    [STAGE_chain] = DEALT,
    [STAGE_chain_end] = DEALT,
    [STAGE_branch_begin] = DEALT,
    [STAGE_branch] = DEALT,
    [STAGE_branch_end] = DEALT,
    [STAGE_hash_bodies] = 16,
    [STAGE_hash_collidables] = 16,
#define CONSTRAINT_KIND(kind, Kind, KIND) [STAGE_##kind##_layout] = CHUNK_ITEMS, [STAGE_##kind##_hash] = 16,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
};

// Stages over all bodies, or all collidables: 1 + the kind of blocks that may be left out.
static const int kinds[STAGE_COUNT] = {
    [STAGE_transform] = 1 + ACTIVE_COLLIDABLES,     [STAGE_solve_begin] = 1 + ACTIVE_BODIES,
    [STAGE_integrate_velocity] = 1 + ACTIVE_BODIES, [STAGE_integrate_position] = 1 + ACTIVE_BODIES,
    [STAGE_finalize] = 1 + ACTIVE_BODIES,           [STAGE_field_shape] = 1 + ACTIVE_COLLIDABLES,
    [STAGE_field_body] = 1 + ACTIVE_BODIES,         [STAGE_body_taut] = 1 + ACTIVE_BODIES,
    [STAGE_body_slack] = 1 + ACTIVE_BODIES,
};

// The blocks that a run of a stage is limited to, or null.
static const ActiveBlocks* active_blocks(const Cpu* cpu, int stage)
{
	int kind = stage < STAGE_COUNT ? kinds[stage] : 0;
	const ActiveBlocks* active = kind ? &cpu->backend.active[kind - 1] : NULL;
	return active && active->blocks ? active : NULL;
}

// A worker's share of the active blocks, those in a row in one call.
static void do_blocks(Cpu* cpu, StageFunction function, const ActiveBlocks* active, int worker, int workers)
{
	int end = split(active->count, worker + 1, workers);
	for (int k = split(active->count, worker, workers); k < end; ++k)
	{
		int first = active->blocks[k] * ACTIVE_ITEMS;
		while (k + 1 < end && active->blocks[k + 1] == active->blocks[k] + 1)
			++k;
		int last = (active->blocks[k] + 1) * ACTIVE_ITEMS;
		if (first < cpu->end)
			function(&cpu->pools, first, last < cpu->end ? last : cpu->end);
	}
}

static void do_dealt(Cpu* cpu, StageFunction function, int worker, int workers)
{
	for (int round = 0, begin = cpu->begin; begin < cpu->end; ++round, begin += workers)
	{
		int item = begin + dealt(round, worker, workers);
		if (item < cpu->end)
			function(&cpu->pools, item, item + 1);
	}
}

static void do_stage(Cpu* cpu, StageId stage, int worker, int workers)
{
	StageFunction function = cpu->functions[stage];
	const ActiveBlocks* active = active_blocks(cpu, stage);
	if (active && cpu->end > 1) // a single item is bookkeeping
	{
		do_blocks(cpu, function, active, worker, workers);
		return;
	}
	if (chunks[stage] == DEALT)
	{
		do_dealt(cpu, function, worker, workers);
		return;
	}
	int items = cpu->end - cpu->begin;
	if (workers > 1 && chunks[stage])
	{
		int chunk = chunks[stage], begin = worker * chunk;
		while (begin < items)
		{
			int end = items - begin < chunk ? items : begin + chunk;
			function(&cpu->pools, cpu->begin + begin, cpu->begin + end);
			begin = workers * chunk + atomic_fetch_add_explicit(&cpu->next, chunk, memory_order_relaxed);
		}
		return;
	}

	// shares consist of whole blocks of MAX_LANES items, so that no two workers write to one block
	int blocks = (items + MAX_LANES - 1) / MAX_LANES;
	int begin = split(blocks, worker, workers) * MAX_LANES;
	int end = split(blocks, worker + 1, workers) * MAX_LANES;
	if (end > items)
		end = items;
	if (begin < end)
		function(&cpu->pools, cpu->begin + begin, cpu->begin + end);
}

// A worker's share of the current run.
static void do_share(Cpu* cpu, int worker, int workers)
{
	const Run* run = &cpu->runs[cpu->at];
	if (run->stage == PRIMITIVE_SORT)
		sort_keys(&cpu->shared, cpu->threads, worker, workers, cpu->pools.key, cpu->pools.key_other, cpu->end,
		          run->argument & 255, run->argument >> 8);
	else if (run->stage == PRIMITIVE_SCAN)
		scan_values(&cpu->shared, cpu->threads, worker, workers, cpu->pools.scan, cpu->end);
	else
		do_stage(cpu, (StageId)run->stage, worker, workers);
}

static int smallest_shared(const Cpu* cpu, int stage)
{
	switch (stage)
	{
	case PRIMITIVE_SORT:
		return SORT_GRAIN;
	case PRIMITIVE_SCAN:
		return SCAN_GRAIN;
	case STAGE_broad_phase_rest: // an item is a part of a long walk: worth sharing while the workers are awake
		return cpu->grain == GRAIN ? 2 : INT_MAX;
	default:
		// a hub takes as long as many items: two are shared wherever anything is
		if (stage_widths[stage] >= WIDTH_GROUP)
			return cpu->grain < ALONE_GRAIN ? 2 : INT_MAX;
		if (!chunks[stage])
			return cpu->grain;
		return 2 * chunks[stage] > cpu->grain / CHUNK_ITEM ? 2 * chunks[stage] : cpu->grain / CHUNK_ITEM;
	}
}

static void count_time(Cpu* cpu, const Run* run)
{
	if (!cpu->timed)
		return;
	if (run->stage < STAGE_COUNT)
		cpu->box = stage_boxes[run->stage];
	double time = processor_milliseconds();
	cpu->milliseconds[cpu->box] += time - cpu->mark;
	cpu->mark = time;
}

// Advances to the next run worth sharing, or to the end of the list. The runs before it are done by the caller.
static void advance(Cpu* cpu)
{
	if (cpu->at >= 0)
		count_time(cpu, &cpu->runs[cpu->at]);
	while (++cpu->at < cpu->count)
	{
		const Run* run = &cpu->runs[cpu->at];
		cpu->begin = run->begin;
		cpu->end = run->end;
		if (run->count != NO_COUNT)
		{
			int bound = ((const int*)cpu->pools.counters)[run->count];
			cpu->end = bound < run->end ? bound : run->end;
		}
		if (cpu->begin >= cpu->end)
			continue;
		cpu->pools.argument = run->argument;
		if (run->stage < STAGE_COUNT)
		{
			// rounding up adds inert items, for which the pools have room
			int lanes = cpu->lanes[run->stage];
			cpu->end = (cpu->end + lanes - 1) / lanes * lanes;
		}

		const ActiveBlocks* active = active_blocks(cpu, run->stage);
		int items = cpu->end - cpu->begin, left = active ? active->count * ACTIVE_ITEMS : items;
		if (cpu->backend.threads > 1 && (left < items ? left : items) >= smallest_shared(cpu, run->stage))
		{
			atomic_store_explicit(&cpu->next, 0, memory_order_relaxed);
			return;
		}
		do_share(cpu, 0, 1);
		count_time(cpu, run);
	}
}

static void worker_loop(void* context, int worker, int workers)
{
	Cpu* cpu = context;
	FloatMode found = float_mode_enter();
	while (cpu->at < cpu->count)
	{
		do_share(cpu, worker, workers);
		if (threads_gather(cpu->threads, worker))
		{
			advance(cpu);
			threads_release(cpu->threads);
		}
	}
	float_mode_leave(found);
}

void cpu_work(Cpu* cpu, const Run* runs, int count, int grain)
{
	cpu->runs = runs;
	cpu->count = count;
	cpu->at = -1;
	cpu->grain = grain;
	FloatMode found = float_mode_enter();
	advance(cpu);
	float_mode_leave(found);
	if (cpu->at < cpu->count)
		threads_run(cpu->threads, worker_loop, cpu);
}
