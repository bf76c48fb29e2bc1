// SPDX-License-Identifier: MIT
// cpu.c -- implements the CPU backend: pools in host memory, and kernels shared by threads.
#include "cpu/cpu.h"
#include "backend/arithmetic.h"
#include "backend/round_trip.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

#define TRAVERSAL_NODES 128 // nodes of a traversal, about 5 us, after which its rest is split
#define TRAVERSAL_ITEMS 4   // number of parts of this rest per worker
#define CHAIN_ITEM      8   // a joint of a chain takes as long as this many colored constraints

static void set_step(Cpu* cpu, const Step* step)
{
	cpu->pools.step = *step;
	if (cpu->timed)
		cpu->mark = processor_milliseconds();
}

static scree_status cpu_run(Backend* b, const Step* step, const Run* runs, int count)
{
	Cpu* cpu = b->state;
	bool detects = false;
	for (int k = 0; k < count; ++k)
		detects = detects || runs[k].kernel_id == KERNEL_narrow_phase;
	set_step(cpu, step);
	cpu_work(cpu, runs, count, cpu->shares || cpu->detected > WAKE_ITEMS ? GRAIN : ALONE_GRAIN);
	if (detects)
		cpu->detected = cpu->items;
	return SCREE_OK;
}

static scree_status cpu_solve(Backend* b, const Step* step, const Solve* solve, RunList* list)
{
	Cpu* cpu = b->state;
	set_step(cpu, step);
	solve_list(solve, list);
	double items = 0, chains = 0;
	for (int k = 0; k < list->count; ++k)
	{
		items += list->runs[k].end - list->runs[k].begin;
		chains += list->runs[k].kernel_id == KERNEL_chain && solve->chains > 1 ? CHAIN_ITEM * solve->chain_places : 0;
	}
	if (threads_workers(cpu->threads) > 1 && items > 0)
		cpu_work_solve(cpu, list->runs, list->count, items, chains);
	else
		cpu_work(cpu, list->runs, list->count, INT_MAX);
	list->count = 0;
	return SCREE_OK;
}

static scree_status cpu_wait(Backend* b)
{
	(void)b; // cpu_run returns after all work is done
	return SCREE_OK;
}

static scree_status cpu_timings(Backend* b, double milliseconds[STAGE_COUNT])
{
	Cpu* cpu = b->state;
	memcpy(milliseconds, cpu->milliseconds, sizeof(cpu->milliseconds));
	memset(cpu->milliseconds, 0, sizeof(cpu->milliseconds));
	return SCREE_OK;
}

// Leaves one core to others (core: true) by using one worker fewer, if the workers occupy all cores; otherwise uses all
// workers. A worker whose core is busy would delay the other workers. Called for device "auto", whose workers are threads of
// the library: with a pool of the user it is the CPU.
static void cpu_spare(Backend* b, bool core)
{
	Cpu* cpu = b->state;
	int workers = core && b->threads > 2 && b->threads >= processor_cores() ? b->threads - 1 : b->threads;
	Threads* threads = workers == threads_workers(cpu->threads) ? NULL : threads_open(workers, NULL);
	if (!threads)
		return;
	threads_close(cpu->threads);
	cpu->threads = threads;
}

static void cpu_close(Backend* b)
{
	Cpu* cpu = b->state;
	cpu_copy_release(b);
	threads_close(cpu->threads);
	cpu_free_pools(cpu);
	scree_release(cpu);
}

static const BackendFunctions functions = {
    .close = cpu_close,
    .resize = cpu_resize,
    .run = cpu_run,
    .solve = cpu_solve,
    .write = cpu_write,
    .read = cpu_read,
    .clear = cpu_clear,
    .keep = cpu_keep,
    .read_begin = cpu_read_begin,
    .read_end = cpu_read_end,
    .round_trip = round_trip_whole,
    .wait = cpu_wait,
    .timings = cpu_timings,
    .address = cpu_address,
    .spare = cpu_spare,
    .searches_open = cpu_searches_open,
    .search = cpu_search,
    .copy_reserve = cpu_copy_reserve,
    .copy_release = cpu_copy_release,
    .copy = cpu_copy,
};

// Selects the functions of all kernels. SCREE_LANES: sum of the numbers of lanes for which this build has kernels.
static void choose_kernels(Cpu* cpu, int lanes)
{
	const KernelFunction *wide = kernels_lanes1, *one = kernels_lanes1;
#if SCREE_LANES & 4
	wide = lanes == 4 ? kernels_lanes4 : wide;
#endif
#if SCREE_LANES & 8
	wide = lanes == 8 ? kernels_lanes8 : wide;
#endif
#if SCREE_LANES & 16
	wide = lanes == 16 ? kernels_lanes16 : wide;
#endif
#if SCREE_LANES >= 8
	one = lanes >= 8 ? kernels_scalar_avx2 : one;
#endif
	cpu->backend.chain_lanes = wide[KERNEL_chain] ? lanes : 1;
	for (int kernel = 0; kernel < KERNEL_COUNT; ++kernel)
	{
		cpu->functions[kernel] = wide[kernel] ? wide[kernel] : one[kernel];
		bool is_wide = kernel_widths[kernel] == WIDTH_WIDE || kernel_widths[kernel] == WIDTH_WIDE_ALONE;
		cpu->lanes[kernel] = is_wide && wide[kernel] ? lanes : 1;
	}
}

scree_status cpu_open(const BackendOptions* options, Backend** backend)
{
	*backend = NULL;
	int widest = processor_widest_lanes();
	int lanes = options->lanes ? options->lanes : widest;
	if (lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16)
		return fail(SCREE_ERROR_INVALID, "lanes is %d, but must be 0, 1, 4, 8 or 16", lanes);
	if (!processor_lanes_compiled(lanes))
		return fail(SCREE_ERROR_INVALID, "lanes is %d, but this build of Scree was compiled without them", lanes);
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
	b->traversal_items = threads > 1 ? TRAVERSAL_ITEMS * threads : 1;
	b->skips = true;
	b->traversal_nodes = threads > 1 ? TRAVERSAL_NODES : INT_MAX;
	b->groups = threads;
	b->state = cpu;
	snprintf(b->name, sizeof(b->name), "cpu");
	cpu->timed = options->timings;
	cpu->flush = arithmetic_setting.flush;
	cpu->choice.shares = true;
	choose_kernels(cpu, lanes);

	cpu->threads = threads_open(threads, options->tasks);
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
		devices[0] = (scree_device){
		    .name = "cpu", .equal_bits = true, .tested = true, .keeps_denormals = true, .keeps_zeros = true};
		devices[0].compute_units = processor_cores();
		devices[0].memory = processor_memory();
		snprintf(devices[0].driver, sizeof(devices[0].driver), "%d lanes, %s", lanes, processor_instructions(lanes));
	}
	return 1;
}
