// SPDX-License-Identifier: MIT
// work.c -- executes lists of runs on the CPU: each run is executed in blocks by several workers, or by one worker.
//
// Worker 0 reads the bound of each run, executes a small run alone, and shares larger runs with the other workers. Thus
// only one worker reads a bound, at a time when no worker writes it, and a small world never wakes a thread.
#include "backend/stage_zone.h"
#include "cpu/cpu.h"
#include "platform/processor.h"
#include <limits.h>

#define CHUNK_ITEM     8    // number of items of other kernels that count as one item of a kernel with chunks
#define DEALT          (-1) // in place of a chunk size: the function dealt distributes the items
#define SORT_GRAIN     8192 // a sort of fewer items than this is executed by one worker
#define SCAN_GRAIN     16384
#define BLOCKS_A_GRAIN 2 // number of blocks of the smallest run that is shared

// Items per chunk. Chunks are for kernels whose items take long, and unequal times: free workers claim the next chunk.
// Other runs are split evenly and in order, so that a worker has the same bodies and constraints in every pass.
static const int chunks[KERNEL_COUNT] = {
    [KERNEL_broad_phase] = CHUNK_ITEMS,
    [KERNEL_broad_phase_rest] = 1,
    [KERNEL_narrow_phase] = CHUNK_ITEMS,
    [KERNEL_query_ray] = CHUNK_ITEMS,
    [KERNEL_query_shape] = CHUNK_ITEMS,
    [KERNEL_query_nearest] = CHUNK_ITEMS,
    [KERNEL_sensor_overlap] = 1,
    [KERNEL_hub] = 1,
    [KERNEL_chain_begin] = DEALT,
    [KERNEL_chain] = DEALT,
    [KERNEL_chain_end] = DEALT,
    [KERNEL_branch_begin] = DEALT,
    [KERNEL_branch] = DEALT,
    [KERNEL_branch_end] = DEALT,
    [KERNEL_hash_bodies] = 16,
    [KERNEL_hash_collidables] = 16,
#define CONSTRAINT_KIND(kind, Kind, KIND) [KERNEL_##kind##_layout] = CHUNK_ITEMS, [KERNEL_##kind##_hash] = 16,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
};

// 1 + ACTIVE_* for kernels over all bodies or all collidables, which may skip inactive blocks; 0 for other kernels.
static const int kinds[KERNEL_COUNT] = {
    [KERNEL_transform] = 1 + ACTIVE_COLLIDABLES,     [KERNEL_solve_begin] = 1 + ACTIVE_BODIES,
    [KERNEL_integrate_velocity] = 1 + ACTIVE_BODIES, [KERNEL_integrate_position] = 1 + ACTIVE_BODIES,
    [KERNEL_finalize] = 1 + ACTIVE_BODIES,           [KERNEL_field_shape] = 1 + ACTIVE_COLLIDABLES,
    [KERNEL_field_body] = 1 + ACTIVE_BODIES,         [KERNEL_body_taut] = 1 + ACTIVE_BODIES,
    [KERNEL_body_slack] = 1 + ACTIVE_BODIES,
};

static const ActiveBlocks* active_blocks(const Cpu* cpu, int kernel)
{
	int kind = kernel < KERNEL_COUNT ? kinds[kernel] : 0;
	const ActiveBlocks* active = kind ? &cpu->backend.active[kind - 1] : NULL;
	return active && active->blocks ? active : NULL;
}

// Executes a share of the active blocks; consecutive blocks are executed in one call.
static void do_active(Cpu* cpu, KernelFunction function, const ActiveBlocks* active, int block, int blocks)
{
	int end = split(active->count, block + 1, blocks);
	for (int k = split(active->count, block, blocks); k < end; ++k)
	{
		int first = active->blocks[k] * ACTIVE_ITEMS;
		while (k + 1 < end && active->blocks[k + 1] == active->blocks[k] + 1)
			++k;
		int last = (active->blocks[k] + 1) * ACTIVE_ITEMS;
		if (first < cpu->end)
			function(&cpu->pools, first, last < cpu->end ? last : cpu->end);
	}
}

static void do_dealt(Cpu* cpu, KernelFunction function, int block, int blocks)
{
	for (int round = 0, begin = cpu->begin; begin < cpu->end; ++round, begin += blocks)
	{
		int item = begin + dealt(round, block, blocks);
		if (item < cpu->end)
			function(&cpu->pools, item, item + 1);
	}
}

static void do_chunks(Cpu* cpu, KernelFunction function, int chunk)
{
	int items = cpu->end - cpu->begin, begin;
	while ((begin = atomic_fetch_add_explicit(&cpu->next, chunk, memory_order_relaxed)) < items)
		function(&cpu->pools, cpu->begin + begin, cpu->begin + (items - begin < chunk ? items : begin + chunk));
}

static void do_block(void* context, int block, int blocks)
{
	Cpu* cpu = context;
	int kernel = cpu->runs[cpu->at].kernel_id, items = cpu->end - cpu->begin;
	KernelFunction function = cpu->functions[kernel];
	const ActiveBlocks* active = active_blocks(cpu, kernel);
	if (cpu->flush)
		float_mode_flush();
	if (active && cpu->end > 1) // a run of one item updates counters, so it is never skipped
		do_active(cpu, function, active, block, blocks);
	else if (chunks[kernel] == DEALT)
		do_dealt(cpu, function, block, blocks);
	else if (blocks > 1 && chunks[kernel])
		do_chunks(cpu, function, chunks[kernel]);
	else
	{
		// shares consist of whole rows of MAX_LANES items, so that two workers never write to the same row
		int rows = (items + MAX_LANES - 1) / MAX_LANES;
		int begin = split(rows, block, blocks) * MAX_LANES, end = split(rows, block + 1, blocks) * MAX_LANES;
		end = end > items ? items : end;
		if (begin < end)
			function(&cpu->pools, cpu->begin + begin, cpu->begin + end);
	}
}

static int smallest_shared(const Cpu* cpu, int kernel)
{
	switch (kernel)
	{
	case PRIMITIVE_SORT:
		return SORT_GRAIN;
	case PRIMITIVE_SCAN:
		return SCAN_GRAIN;
	case KERNEL_broad_phase_rest: // parts of a long traversal are shared while the workers are awake
		return cpu->grain == GRAIN ? 2 : INT_MAX;
	default:
		// a hub takes as long as many items, so two hubs are shared, unless the workers are asleep
		if (kernel_widths[kernel] >= WIDTH_GROUP)
			return cpu->grain < ALONE_GRAIN ? 2 : INT_MAX;
		if (!chunks[kernel])
			return cpu->grain;
		return 2 * chunks[kernel] > cpu->grain / CHUNK_ITEM ? 2 * chunks[kernel] : cpu->grain / CHUNK_ITEM;
	}
}

static void count_time(Cpu* cpu, const Run* run)
{
	if (!cpu->timed)
		return;
	if (run->kernel_id < KERNEL_COUNT)
		cpu->stage = kernel_stages[run->kernel_id];
	double time = processor_milliseconds();
	cpu->milliseconds[cpu->stage] += time - cpu->mark;
	cpu->mark = time;
}

// Returns the number of blocks of a run: 1 if one worker executes it.
static int count_blocks(const Cpu* cpu, int kernel, int items, const ActiveBlocks* active)
{
	int workers = cpu->backend.alone ? 1 : threads_workers(cpu->threads), least = smallest_shared(cpu, kernel),
	    most = workers;
	if (workers == 1 || items < least)
		return 1;
	if (kernel >= KERNEL_COUNT)
		return workers;
	if (active)
		most = active->count;
	else if (kernel_widths[kernel] >= WIDTH_GROUP || chunks[kernel] == DEALT)
		most = items;
	else if (chunks[kernel])
		most = (items + chunks[kernel] - 1) / chunks[kernel];
	else
		most = items / (cpu->grain / BLOCKS_A_GRAIN);
	return most < workers ? most : workers;
}

// Sets cpu->begin and cpu->end to the range of the run's items. Returns the number of blocks, 0 if there are no items.
static int begin_run(Cpu* cpu, const Run* run)
{
	cpu->begin = run->begin;
	cpu->end = run->end;
	if (run->count != NO_COUNT)
	{
		int bound = ((const int*)cpu->pools.counters)[run->count];
		cpu->end = bound < run->end ? bound : run->end;
	}
	if (cpu->begin >= cpu->end)
		return 0;
	cpu->pools.argument = run->argument;
	if (run->kernel_id < KERNEL_COUNT)
	{
		// rounding up adds items without effect, for which the pools have space
		int lanes = cpu->lanes[run->kernel_id];
		cpu->end = (cpu->end + lanes - 1) / lanes * lanes;
	}
	const ActiveBlocks* active = active_blocks(cpu, run->kernel_id);
	int items = cpu->end - cpu->begin, left = active ? active->count * ACTIVE_ITEMS : items;
	items = left < items ? left : items;
	cpu->items += items;
	return count_blocks(cpu, run->kernel_id, items, active);
}

void cpu_work(Cpu* cpu, const Run* runs, int count, int grain)
{
	bool shared = false;
	StageZone zone = {0};
	cpu->runs = runs;
	cpu->grain = grain;
	cpu->items = 0.0;
	FloatMode found = float_mode_enter();
	for (cpu->at = 0; cpu->at < count; ++cpu->at)
	{
		const Run* run = &runs[cpu->at];
		int blocks = begin_run(cpu, run);
		if (blocks == 0)
			continue;
		if (run->kernel_id < KERNEL_COUNT) // sorts and scans belong to the stage before them
			stage_zone_begin(&zone, kernel_stages[run->kernel_id]);
		if (blocks > 1 && !shared)
		{
			threads_begin(cpu->threads);
			shared = true;
		}
		if (run->kernel_id == PRIMITIVE_SORT)
			sort_keys(&cpu->shared, cpu->threads, blocks, cpu->pools.key, cpu->pools.key_other, cpu->end,
			          RUN_LOW(run->argument), RUN_HIGH(run->argument));
		else if (run->kernel_id == PRIMITIVE_SCAN)
			scan_values(&cpu->shared, cpu->threads, blocks, cpu->pools.scan, cpu->end);
		else
		{
			atomic_store_explicit(&cpu->next, 0, memory_order_relaxed);
			threads_run(cpu->threads, do_block, cpu, blocks);
		}
		count_time(cpu, run);
	}
	if (shared)
		threads_end(cpu->threads);
	stage_zone_end(&zone);
	float_mode_leave(found);
}
