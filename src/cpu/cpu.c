// SPDX-License-Identifier: MIT
// cpu.c -- the CPU backend: pools in host memory, stages split over threads.
//
// A list of runs is worked through in one parallel region, with a barrier after each run. The last worker to arrive at
// the barrier looks up the bound of the next run, does small runs by itself on the way, and lets the others go on when
// there is something to share. So bounds are read once, by one worker, when nobody writes them, and a small world never
// wakes a thread.
#include "backend/backend.h"
#include "cpu/lanes.h"
#include "cpu/primitives.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "platform/threads.h"
#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

// Runs of fewer items than this are done by one worker: a barrier costs a microsecond, an item a few nanoseconds. In the
// solve, what another core wrote last costs more than the barrier, so that nearly all runs are shared, or none (Choice).
#define GRAIN       512
#define SOLVE_GRAIN 64
// The same where the solve was done alone: meanwhile the other workers have fallen asleep, and to wake them takes 50 us.
#define ALONE_GRAIN 4096
// An item of a stage that is handed out in chunks takes as long as so many of others.
#define CHUNK_ITEM 8
// A walk of more nodes than this, some 5 us, is cut into so many parts a worker.
#define WALK_NODES 128
#define WALKERS    4
#define SORT_GRAIN 8192
#define SCAN_GRAIN 16384

// Solves with more items a run than this are always shared. The slower way is tried again after so many solves, times the
// square of how much slower it was.
#define ALWAYS_SHARED 2048
#define REST          32
// beyond so many times slower, which a busy machine can feign, it is tried no more seldom
#define MOST_SLOWER 8.0
// so many solves take turns at first: one alone may have been interrupted
#define FIRST_SOLVES 8

// Stages whose items take long, and unequally long, are handed out in chunks to whoever is free. The others are split
// evenly and in order, so that a worker meets the same bodies and constraints in every pass.
static const int chunks[STAGE_COUNT] = {
    [STAGE_broad_phase] = HANDED_ITEMS,
    [STAGE_broad_phase_rest] = 1,
    [STAGE_narrow_phase] = HANDED_ITEMS,
    [STAGE_hub] = 1,
    [STAGE_hash_bodies] = 16,
    [STAGE_hash_collidables] = 16,
#define CONSTRAINT_KIND(kind, Kind, KIND) [STAGE_##kind##_hash] = 16,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
};

static const size_t pool_offsets[POOL_COUNT] = {
#define X(type, name, per, role) offsetof(Pools, name),
#include "pools/pools.def"
#undef X
};

// items that the pools really have room for: wide stages round up
static size_t padded(int capacity) { return ((size_t)capacity + MAX_LANES - 1) / MAX_LANES * MAX_LANES; }

typedef struct // whether workers share the solve: the clock decides, since it depends on how far cores are apart
{
	double cost[2]; // ns an item, alone and shared; 0 before the first time
	int solves;     // that took turns at first
	int rest;       // solves until the slower way is tried again
	bool shares;
} Choice;

typedef struct
{
	Backend backend;
	Pools pools;
	Threads* threads;
	Choice choice;
	StageFunction functions[STAGE_COUNT];
	int lanes[STAGE_COUNT]; // items that a function does at once
	bool timed;
	Box box;     // of the last stage; a primitive counts to the box of the stage before it
	double mark; // ms, when the last run ended
	double milliseconds[BOX_COUNT];

	// between read_begin and read_end
	size_t held_count;
	unsigned char held[READ_ASYNC_BYTES];

	// between copy_reserve and copy_release
	char *copy_from, *copy_to;
	size_t copy_bytes;
	int copy_times;

	// the list at work, and the items of run number at; written by one worker while the others wait
	const Run* runs;
	int count, at, begin, end;
	int grain; // fewest items worth sharing

	_Alignas(64) atomic_int next; // first item that nobody has taken, of a run in chunks
	Shared shared;
} Cpu;

static void do_stage(Cpu* cpu, StageId stage, int worker, int workers)
{
	StageFunction function = cpu->functions[stage];
	int items = cpu->end - cpu->begin;
	if (workers > 1 && chunks[stage])
	{
		for (;;)
		{
			int begin = atomic_fetch_add_explicit(&cpu->next, chunks[stage], memory_order_relaxed);
			if (begin >= items)
				return;
			int end = items - begin < chunks[stage] ? items : begin + chunks[stage];
			function(&cpu->pools, cpu->begin + begin, cpu->begin + end);
		}
	}

	// shares are whole blocks of the widest lanes, so that no two workers write to one
	int blocks = (items + MAX_LANES - 1) / MAX_LANES;
	int begin = split(blocks, worker, workers) * MAX_LANES;
	int end = split(blocks, worker + 1, workers) * MAX_LANES;
	if (end > items)
		end = items;
	if (begin < end)
		function(&cpu->pools, cpu->begin + begin, cpu->begin + end);
}

// A worker's share of the run at work.
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
	case STAGE_broad_phase_rest: // each item is a part of a long walk: worth a worker that is awake
		return cpu->grain == GRAIN ? 2 : INT_MAX;
	default:
		// a hub takes as long as many items: two are worth sharing wherever anything is
		if (stage_widths[stage] == WIDTH_GROUP)
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

// Goes on to the next run worth sharing, or to the end of the list; what is not worth it is done on the way.
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
			// what rounding adds is padding: inert items that the pools have room for
			int lanes = cpu->lanes[run->stage];
			cpu->end = (cpu->end + lanes - 1) / lanes * lanes;
		}

		if (cpu->backend.threads > 1 && cpu->end - cpu->begin >= smallest_shared(cpu, run->stage))
		{
			atomic_store_explicit(&cpu->next, 0, memory_order_relaxed);
			return;
		}
		do_share(cpu, 0, 1);
		count_time(cpu, run);
	}
}

static void work(void* context, int worker, int workers)
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

static void run_list(Cpu* cpu, const Run* runs, int count, int grain)
{
	cpu->runs = runs;
	cpu->count = count;
	cpu->at = -1;
	cpu->grain = grain;
	FloatMode found = float_mode_enter();
	advance(cpu);
	float_mode_leave(found);
	if (cpu->at < cpu->count)
		threads_run(cpu->threads, work, cpu);
}

// A solve of so many items, in the way that took less time before. The other way is tried now and then, the more seldom
// the slower it was. A time that is longer than before may be that of an interruption, and counts for a quarter.
static void run_solve(Cpu* cpu, const Run* runs, int count, double items)
{
	Choice* c = &cpu->choice;
	double mean = items / count;
	bool open = mean >= SOLVE_GRAIN && mean <= ALWAYS_SHARED, first = open && c->solves < FIRST_SOLVES;
	bool tries = open && !first && --c->rest < 0;
	if (!open)
		c->shares = mean > ALWAYS_SHARED;
	else
		c->shares = first ? c->solves % 2 == 0 : (c->cost[1] < c->cost[0]) != tries;
	c->solves += first;
	double begin = processor_milliseconds();
	run_list(cpu, runs, count, c->shares ? SOLVE_GRAIN : INT_MAX);
	double cost = 1e6 * (processor_milliseconds() - begin) / items, *known = &c->cost[c->shares];
	*known = *known > 0 && cost > *known ? 0.75 * *known + 0.25 * cost : cost;
	if (tries)
	{
		double slower = c->cost[c->shares] / c->cost[!c->shares];
		slower = slower < MOST_SLOWER ? slower : MOST_SLOWER;
		c->rest = slower > 1 ? (int)(REST * slower * slower) : REST;
	}
}

static void set_step(Cpu* cpu, const Step* step)
{
	cpu->pools.step = *step;
	if (cpu->timed)
		cpu->mark = processor_milliseconds();
}

static scree_status cpu_run(Backend* b, const Step* step, const Run* runs, int count)
{
	Cpu* cpu = b->state;
	set_step(cpu, step);
	run_list(cpu, runs, count, cpu->choice.shares ? GRAIN : ALONE_GRAIN);
	return SCREE_OK;
}

static scree_status cpu_solve(Backend* b, const Step* step, const Solve* solve, RunList* list)
{
	Cpu* cpu = b->state;
	set_step(cpu, step);
	solve_list(solve, list);
	double items = 0;
	for (int k = 0; k < list->count; ++k)
		items += list->runs[k].end - list->runs[k].begin;
	if (b->threads > 1 && items > 0)
		run_solve(cpu, list->runs, list->count, items);
	else
		run_list(cpu, list->runs, list->count, INT_MAX);
	list->count = 0;
	return SCREE_OK;
}

static char* pool_memory(const Cpu* cpu, PoolId pool)
{
	char* memory;
	memcpy(&memory, (const char*)&cpu->pools + pool_offsets[pool], sizeof(memory));
	return memory;
}

static scree_status cpu_resize(Backend* b, Per per, int capacity)
{
	Cpu* cpu = b->state;
	if (capacity == b->capacity[per])
		return SCREE_OK;
	size_t items = padded(capacity), old_items = padded(b->capacity[per]);
	uint64_t added = 0; // wraps around when pools shrink
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (pool_info[pool].per != per)
			continue;
		// A pool that has grown when the next one fails only has more room than it is known to have.
		size_t bytes = pool_info[pool].bytes;
		char* memory = scree_reallocate(pool_memory(cpu, pool), old_items * bytes, items * bytes);
		if (!memory && capacity > b->capacity[per])
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d items of pool %s (%zu bytes each)", capacity,
			            pool_info[pool].name, bytes);
		if (memory) // else it has more room than it is known to have, until it grows
			memcpy((char*)&cpu->pools + pool_offsets[pool], &memory, sizeof(memory));
		added += (items - old_items) * bytes;
	}
	b->capacity[per] = capacity;
	b->bytes += added;
	return SCREE_OK;
}

static scree_status cpu_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count > 0)
		memcpy(pool_memory(b->state, pool) + (size_t)first * bytes, items, (size_t)count * bytes);
	return SCREE_OK;
}

static scree_status cpu_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count > 0)
		memcpy(items, pool_memory(b->state, pool) + (size_t)first * bytes, (size_t)count * bytes);
	return SCREE_OK;
}

static scree_status cpu_read_begin(Backend* b, PoolId pool, int first, int count)
{
	Cpu* cpu = b->state;
	cpu->held_count = (size_t)count * pool_info[pool].bytes;
	ASSERT(cpu->held_count <= READ_ASYNC_BYTES);
	return cpu_read(b, pool, first, count, cpu->held);
}

static scree_status cpu_read_end(Backend* b, void* items)
{
	const Cpu* cpu = b->state;
	memcpy(items, cpu->held, cpu->held_count);
	return SCREE_OK;
}

static scree_status cpu_wait(Backend* b)
{
	(void)b; // run returns when all is done
	return SCREE_OK;
}

static scree_status cpu_timings(Backend* b, double milliseconds[BOX_COUNT])
{
	Cpu* cpu = b->state;
	memcpy(milliseconds, cpu->milliseconds, sizeof(cpu->milliseconds));
	memset(cpu->milliseconds, 0, sizeof(cpu->milliseconds));
	return SCREE_OK;
}

static void* cpu_address(Backend* b, PoolId pool) { return pool_memory(b->state, pool); }

// Workers meet a hundred times a step: one whose core is taken holds up all others, and one worker fewer does not.
static void cpu_spare(Backend* b, bool core)
{
	Cpu* cpu = b->state;
	int workers = core && b->threads > 2 && b->threads >= processor_cores() ? b->threads - 1 : b->threads;
	Threads* threads = workers == threads_workers(cpu->threads) ? NULL : threads_open(workers);
	if (!threads)
		return;
	threads_close(cpu->threads);
	cpu->threads = threads;
}

static void cpu_copy_release(Backend* b)
{
	Cpu* cpu = b->state;
	scree_release(cpu->copy_from);
	scree_release(cpu->copy_to);
	cpu->copy_from = cpu->copy_to = NULL;
}

static scree_status cpu_copy_reserve(Backend* b, size_t bytes)
{
	Cpu* cpu = b->state;
	cpu_copy_release(b);
	cpu->copy_from = scree_allocate(bytes);
	cpu->copy_to = scree_allocate(bytes);
	cpu->copy_bytes = bytes;
	if (cpu->copy_from && cpu->copy_to)
		return SCREE_OK;
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for two blocks of %zu bytes", bytes);
}

static void copy_share(void* context, int worker, int workers)
{
	const Cpu* cpu = context;
	size_t begin = cpu->copy_bytes / (size_t)workers * (size_t)worker;
	size_t end = worker + 1 == workers ? cpu->copy_bytes : cpu->copy_bytes / (size_t)workers * (size_t)(worker + 1);
	for (int k = 0; k < cpu->copy_times; ++k)
		memcpy(cpu->copy_to + begin, cpu->copy_from + begin, end - begin);
}

static scree_status cpu_copy(Backend* b, int times)
{
	Cpu* cpu = b->state;
	cpu->copy_times = times;
	threads_run(cpu->threads, copy_share, cpu);
	return SCREE_OK;
}

static void cpu_close(Backend* b)
{
	Cpu* cpu = b->state;
	cpu_copy_release(b);
	threads_close(cpu->threads);
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		scree_release(pool_memory(cpu, pool));
	scree_release(cpu);
}

static const BackendFunctions functions = {
    .close = cpu_close,
    .resize = cpu_resize,
    .run = cpu_run,
    .solve = cpu_solve,
    .write = cpu_write,
    .read = cpu_read,
    .read_begin = cpu_read_begin,
    .read_end = cpu_read_end,
    .wait = cpu_wait,
    .timings = cpu_timings,
    .address = cpu_address,
    .spare = cpu_spare,
    .copy_reserve = cpu_copy_reserve,
    .copy_release = cpu_copy_release,
    .copy = cpu_copy,
};

static void choose_stages(Cpu* cpu, int lanes)
{
	const StageFunction* wide = lanes == 16  ? stages_lanes16
	                            : lanes == 8 ? stages_lanes8
	                            : lanes == 4 ? stages_lanes4
	                                         : stages_lanes1;
	const StageFunction* one = lanes >= 8 ? stages_one8 : stages_lanes1;
	for (int stage = 0; stage < STAGE_COUNT; ++stage)
	{
		cpu->functions[stage] = wide[stage] ? wide[stage] : one[stage];
		cpu->lanes[stage] = stage_widths[stage] == WIDTH_WIDE ? lanes : 1;
	}
}

scree_status cpu_open(const BackendOptions* options, Backend** backend)
{
	*backend = NULL;
	int widest = processor_widest_lanes();
	int lanes = options->lanes ? options->lanes : widest;
	if (lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16)
		return fail(SCREE_ERROR_INVALID, "lanes is %d, but must be 0, 1, 4, 8 or 16", lanes);
	if (!processor_has_lanes(lanes))
		return fail(SCREE_ERROR_INVALID, "lanes is %d, but this processor has %d at most (%s)", lanes, widest,
		            processor_instructions(widest));
	if (options->threads < 0 || options->threads > MAX_WORKERS)
		return fail(SCREE_ERROR_INVALID, "threads is %d, but must be 0 to %d", options->threads, MAX_WORKERS);
	int cores = processor_cores();
	int threads = options->threads ? options->threads : cores < MAX_WORKERS ? cores : MAX_WORKERS;

	Cpu* cpu = scree_allocate(sizeof(Cpu));
	if (!cpu)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the CPU backend (%zu bytes)", sizeof(Cpu));
	Backend* b = &cpu->backend;
	b->f = &functions;
	b->threads = threads;
	b->lanes = lanes;
	b->walkers = threads > 1 ? WALKERS * threads : 1;
	b->walk_nodes = threads > 1 ? WALK_NODES : INT_MAX;
	b->state = cpu;
	snprintf(b->name, sizeof(b->name), "cpu");
	cpu->timed = options->timings;
	choose_stages(cpu, lanes);

	cpu->threads = threads_open(threads);
	if (!cpu->threads)
	{
		cpu_close(b);
		return SCREE_ERROR_OUT_OF_MEMORY;
	}
	*backend = b;
	return SCREE_OK;
}

int cpu_devices(scree_device* devices, int capacity)
{
	if (capacity > 0)
	{
		int lanes = processor_widest_lanes();
		devices[0] = (scree_device){.name = "cpu", .equal_bits = true};
		devices[0].units = processor_cores();
		devices[0].memory = processor_memory();
		snprintf(devices[0].driver, sizeof(devices[0].driver), "%d lanes, %s", lanes, processor_instructions(lanes));
	}
	return 1;
}
