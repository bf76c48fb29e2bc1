// SPDX-License-Identifier: MIT
// opencl_backend.c -- implements the OpenCL backend: buffers by kind of item, kernels, and one in-order queue.
#include "opencl/arithmetic_test.h"
#include "opencl/buffer.h"
#include "opencl/compile.h"
#include "opencl/context.h"
#include "opencl/copy_bandwidth.h"
#include "opencl/execute.h"
#include "opencl/external_memory.h"
#include "opencl/forms/bay_solve.h"
#include "opencl/forms/form.h"
#include "opencl/forms/relay.h"
#include "opencl/forms/tiles.h"
#include "opencl/gate.h"
#include "opencl/launch.h"
#include "opencl/persistent.h"
#include "opencl/primitives.h"
#include "opencl/queue.h"
#include "opencl/readback.h"
#include "opencl/round_trip_parts.h"
#include "opencl/transfer.h"
#include "platform/error.h"
#include <limits.h>
#include <stdio.h>

#define CAPACITY_ITEMS (POOL_ALIGNMENT / 4) // capacities are multiples of this; items have at least 4 bytes

static void opencl_close(Backend* b)
{
	OpenCl* d = b->state;
	const Sentence kept = sentence_keep(); // an earlier error may be the reason of the call
	if (d)
	{
		if (d->queue)
			finish_to_close(d);
		tiles_close(d);
		relay_close(d);
		bay_solve_close(d);
		for (int k = 0; k < PINNED_MOST; ++k)
			pinned_close(d, d->pinned + k);
		persistent_close(d);
		primitives_close(d);
		for (int i = 0; i < KERNEL_COUNT; ++i)
			RELEASE(d->failure, Kernel, d->kernels[i].kernel);
		for (int i = 0; i < PLAIN_KERNELS; ++i)
			RELEASE(d->failure, Kernel, d->plain[i].kernel);
		RELEASE(d->failure, Kernel, d->solve_end.kernel);
		read_close(d);
		round_trip_close(d);
		transfer_close(d);
		pinned_close(d, &d->staging.pinned);
		shared_close(d);
		opencl_copy_release(b);
		for (int i = 0; i < PER_COUNT; ++i)
			RELEASE(d->failure, MemObject, d->buffers[i]);
		RELEASE(d->failure, CommandQueue, d->queue);
		context_close(d);
		scree_release(d->timing.laps);
		scree_release(d);
	}
	scree_release(b);
	sentence_restore(&kept);
}

static size_t item_bytes(Per per)
{
	size_t bytes = 0;
	for (int i = 0; i < POOL_COUNT; ++i)
		bytes += pool_info[i].per == per ? pool_info[i].bytes : 0;
	return bytes;
}

typedef struct // new layout of a buffer: beginnings and capacities of its kinds, and its size in bytes
{
	size_t begin[PER_COUNT], bytes;
	int room[PER_COUNT];
} Plan;

// Copies the items of a pool to its place in the buffer `copied`, whose layout is `plan`.
static scree_status pool_copy(OpenCl* d, PoolId pool, const Plan* plan, cl_mem copied)
{
	Per per = pool_info[pool].per;
	int items = plan->room[per] < d->room[per] ? plan->room[per] : d->room[per];
	return CALL(d->failure, EnqueueCopyBuffer, d->queue, pool_buffer(d, pool), copied, pool_offset(d, pool),
	            plan->begin[per] + d->before[pool] * (size_t)plan->room[per], pool_info[pool].bytes * (size_t)items, 0,
	            NULL, NULL);
}

// Replaces the buffer of a kind by a buffer with the layout `plan`. Copies the items; new items are zero.
static scree_status buffer_copy(OpenCl* d, Per home, const Plan* plan)
{
	cl_mem copied;
	scree_status status = buffer_create(d, plan->bytes, &copied);
	for (int i = 0; i < POOL_COUNT && status == SCREE_OK; ++i)
		if (d->home[pool_info[i].per] == home && d->buffers[home] && d->room[pool_info[i].per] > 0)
			status = pool_copy(d, (PoolId)i, plan, copied);
	if (status == SCREE_OK)
		status = finish(d); // drivers that allocate on first use fail here
	cl_mem dropped = copied;
	if (status == SCREE_OK)
	{
		dropped = d->buffers[home];
		d->buffers[home] = copied;
		memcpy(d->begin, plan->begin, sizeof d->begin);
		memcpy(d->room, plan->room, sizeof d->room);
	}
	RELEASE(d->failure, MemObject, dropped);
	return status;
}

// Sets the capacity of a kind to the given number of items, rounded up; fails if memory is insufficient.
static scree_status kind_reserve(Backend* b, Per per, int capacity)
{
	OpenCl* d = b->state;
	// both the old and the new buffer exist during the copy
	size_t bytes = item_bytes(per);
	uint64_t wanted = (uint64_t)bytes * (uint64_t)capacity, old = (uint64_t)bytes * (uint64_t)d->room[per];
	if (capacity > INT_MAX - CAPACITY_ITEMS || b->bytes + wanted > d->device.about.memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY,
		            "%s has %llu MB; pools of %llu MB and their growth by %llu MB do not fit.", b->name,
		            (unsigned long long)(d->device.about.memory >> 20), (unsigned long long)(b->bytes >> 20),
		            (unsigned long long)(wanted >> 20));
	Plan plan = {.bytes = 0};
	memcpy(plan.begin, d->begin, sizeof plan.begin);
	memcpy(plan.room, d->room, sizeof plan.room);
	plan.room[per] = (capacity + CAPACITY_ITEMS - 1) / CAPACITY_ITEMS * CAPACITY_ITEMS;
	Per home = d->home[per];
	plan.bytes = item_bytes(home) * (size_t)plan.room[home];
	for (int i = 0; i < PER_COUNT; ++i)
	{
		if (d->home[i] != home || i == (int)home)
			continue;
		plan.begin[i] = plan.bytes;
		plan.bytes += item_bytes((Per)i) * (size_t)plan.room[i];
	}
	TRY(buffer_copy(d, home, &plan));
	b->bytes += (uint64_t)bytes * (uint64_t)d->room[per] - old;
	return SCREE_OK;
}

static scree_status kernels_bind(OpenCl* d, Per per)
{
	for (int k = 0; k < KERNEL_COUNT; ++k)
		TRY(kernel_bind(d, per, &d->kernels[k]));
	for (int k = 0; k < PLAIN_KERNELS; ++k)
		TRY(kernel_bind(d, per, &d->plain[k]));
	if (d->resident)
	{
		if (d->persistent.kernel.kernel)
			TRY(kernel_bind(d, per, &d->persistent.kernel));
		TRY(relay_bind(d, per));
		TRY(bay_solve_bind(d, per));
		TRY(kernel_bind(d, per, &d->solve_end));
		TRY(tiles_bind(d, per));
	}
	return primitives_bind(d);
}

// Releases all scratch buffers of the solve, so that they can shrink; the next solve reserves them again.
static scree_status solve_drop(OpenCl* d)
{
	Scratch* scratch[TILE_BUFFERS + 3] = {&d->relay.mailboxes, &d->relay.stream, &d->relay.parts};
	for (int k = 0; k < TILE_BUFFERS; ++k)
		scratch[k + 3] = &d->tiles.buffers[k];
	d->tiles.stale = true;
	return scratch_drop(d, scratch, TILE_BUFFERS + 3);
}

static scree_status opencl_resize(Backend* b, Per per, int capacity)
{
	OpenCl* d = b->state;
	if (capacity > d->room[per] || capacity < b->capacity[per])
	{
		TRY(kind_reserve(b, per, capacity));
		TRY(kernels_bind(d, per));
	}
	if (per == PER_EDGE && capacity < b->capacity[per])
		TRY(solve_drop(d));
	b->capacity[per] = capacity;
	return SCREE_OK;
}

// Assigns a buffer to each kind, an offset to each pool of a kind, and an argument index to each buffer.
static void lay_out(OpenCl* d)
{
	size_t before[PER_COUNT] = {0};
	int kinds = 0, buffers = 0, sharing = 0;
	for (int i = 0; i < PER_COUNT; ++i)
		d->home[i] = (Per)i;
#define SHARES(kind, with) d->home[PER_##kind] = PER_##with;
#include "pools/buffers.def"
#undef SHARES
	for (int i = 0; i < POOL_COUNT; ++i)
	{
		Per per = pool_info[i].per;
		if (before[per] == 0)
		{
			d->place[per] = kinds++;
			d->argument[per] = d->home[per] == per ? buffers++ : sharing++;
		}
		d->before[i] = before[per];
		before[per] += pool_info[i].bytes;
	}
	ASSERT(kinds == PER_COUNT && buffers == BUFFERS);
}

static scree_status opencl_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count == 0)
		return SCREE_OK;
	// a migration to this device writes these pools, and makes existing tiles stale
	Per per = pool_info[pool].per;
	d->tiles.stale |= per == PER_CONTACT || per == PER_CONTACT_PLACE || per == PER_BODY;
	size_t offset = pool_offset(d, pool) + bytes * (size_t)first, all = bytes * (size_t)count;
	if (is_pinned(d, items, all))
		return CALL(d->failure, EnqueueWriteBuffer, d->queue, pool_buffer(d, pool), CL_FALSE, offset, all, items, 0,
		            NULL, NULL);
	return transfer_wanted(d, all) ? transfer_up(d, pool_buffer(d, pool), offset, items, all)
	                               : upload(d, pool_buffer(d, pool), offset, items, all);
}

static scree_status opencl_clear(Backend* b, PoolId pool, int first, int count)
{
	OpenCl* d = b->state;
	const cl_int zero = 0;
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count == 0)
		return SCREE_OK;
	return CALL(d->failure, EnqueueFillBuffer, d->queue, pool_buffer(d, pool), &zero, sizeof zero,
	            pool_offset(d, pool) + bytes * (size_t)first, bytes * (size_t)count, 0, NULL, NULL);
}

static scree_status opencl_keep(Backend* b, PoolId pool, int first, int count, int at, bool back)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	size_t here = pool_offset(d, pool) + bytes * (size_t)first;
	size_t there = pool_offset(d, POOL_saved) + pool_info[POOL_saved].bytes * (size_t)at;
	cl_mem buffer = pool_buffer(d, pool), saved = pool_buffer(d, POOL_saved);
	if (count == 0)
		return SCREE_OK;
	d->tiles.stale |= back;
	return CALL(d->failure, EnqueueCopyBuffer, d->queue, back ? saved : buffer, back ? buffer : saved,
	            back ? there : here, back ? here : there, bytes * (size_t)count, 0, NULL, NULL);
}

static scree_status opencl_wait(Backend* b) { return finish(b->state); }

// Returns the maximum number of work-items per group of a kernel. It is 1 for branches on a CPU, because PoCL would
// compile their barriers for two minutes.
static size_t kernel_group(const OpenCl* d, int stage)
{
	if (kernel_widths[stage] == WIDTH_TEAM && d->device.type & CL_DEVICE_TYPE_CPU)
		return 1;
	if (stage == KERNEL_continuous)
		return CONTINUOUS_GROUP;
	return kernel_widths[stage] >= WIDTH_GROUP ? HUB_GROUP : KERNEL_GROUP;
}

static scree_status open_device(Backend* b, const BackendOptions* options, const Device* device)
{
	OpenCl* d = b->state = scree_allocate(sizeof *d);
	if (!d)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for an OpenCL device.");
	d->backend = b;
	d->beside = options->beside ? options->beside->state : NULL;
	d->failure = &d->own_failure;
	d->wait_limit = device_wait_limit(device, options);
	d->constants.version = 1; // version 0 of new kernels differs from this, so their first launch sets the step
	d->device = *device;
	if (options->tasks)
		d->transfer.tasks = *options->tasks;
	snprintf(b->name, sizeof b->name, "%s", d->device.about.name);
	b->memory = d->device.about.memory;
	b->traversal_items = d->device.about.compute_units * KERNEL_GROUP;
	b->traversal_nodes = TRAVERSAL_NODES;
	b->chain_lanes = 1;
	b->groups = d->device.about.compute_units;

	bool cpu = d->device.type & CL_DEVICE_TYPE_CPU;
	d->form = solve_form_setting;
	d->persistent.any_size = d->form == FORM_RELAY || d->form == FORM_TILES;
	d->resident = d->persistent.any_size || (d->form == FORM_ANY && !cpu);
	char program_options[PROGRAM_OPTIONS], arithmetic[ARITHMETIC_OPTIONS];
	// PoCL compiles a kernel at its first launch, so unused kernels cost no time, and all worlds can share one program.
	// Other devices have a program for worlds alone, which are slower with the code for batches.
	bool resident = d->resident || d->device.compiles_at_launch,
	     alone = !options->batch && !d->device.compiles_at_launch;
	bool tiles = d->device.local_memory >= TILE_MEMORY;
	arithmetic_options(d->device.own_rounding, arithmetic);
	snprintf(program_options, sizeof program_options, "%s%s%s%s%s%s", resident ? " -DRESIDENT" : "",
	         resident && tiles ? " -DTILES" : "", d->resident && !cpu ? " -DPERSISTENT" : "", cpu ? " -DCALLS" : "",
	         alone ? " -DWORLD_ALONE" : "", arithmetic);
	TRY(context_open(d, program_options, options->opengl));
	cl_int error;
	CREATE(d->failure, d->queue, error, CommandQueue, d->context, d->device.id,
	       options->timings ? CL_QUEUE_PROFILING_ENABLE : 0);
	TRY(context_check(d->failure, "clCreateCommandQueue", error));
	TRY(read_open(d));
	TRY(pinned_open(d, STAGING_BYTES, &d->staging.pinned));
	if (options->timings)
		TRY(timing_open(d));
	for (int i = 0; i < KERNEL_COUNT; ++i)
		TRY(kernel_create(d, kernel_names[i], kernel_group(d, i), &d->kernels[i]));
	TRY(kernel_create(d, "narrow_phase_plain", KERNEL_GROUP, &d->plain[PLAIN_NARROW_PHASE]));
	TRY(kernel_create(d, "continuous_plain", CONTINUOUS_GROUP, &d->plain[PLAIN_CONTINUOUS]));
	if (d->resident)
	{
		if (!cpu)
			TRY(kernel_create(d, "persistent", PERSISTENT_GROUP, &d->persistent.kernel));
		TRY(relay_create(d));
		TRY(kernel_create(d, "solve_end", KERNEL_GROUP, &d->solve_end));
		if (tiles)
		{
			TRY(tiles_open(d));
			TRY(bay_solve_open(d));
		}
		else
			log_sentence(SCREE_LOG_INFO, "%s has %zu bytes of local memory; the solver does without tiles.",
			             d->device.about.name, d->device.local_memory);
	}
	TRY(primitives_open(d));

	// pools without items have a capacity too, because every kernel argument needs a buffer
	lay_out(d);
	for (int i = 0; i < PER_COUNT; ++i)
		TRY(kind_reserve(b, (Per)i, 1));
	for (int i = 0; i < PER_COUNT; ++i)
		TRY(kernels_bind(d, (Per)i));
	if (d->resident)
	{
		if (!cpu)
			TRY(persistent_open(d));
		TRY(relay_open(d));
	}
	return finish(d);
}

static scree_status opencl_open_device(const BackendOptions* options, const Device* device, Backend** backend)
{
	static const BackendFunctions functions = {
	    .close = opencl_close,
	    .resize = opencl_resize,
	    .run = opencl_run,
	    .solve = opencl_solve,
	    .finds_layout = opencl_finds_layout,
	    .write = opencl_write,
	    .read = opencl_read,
	    .clear = opencl_clear,
	    .keep = opencl_keep,
	    .read_begin = opencl_read_begin,
	    .read_end = opencl_read_end,
	    .round_trip = opencl_round_trip,
	    .wait = opencl_wait,
	    .timings = opencl_timings,
	    .share = opencl_share,
	    .render = opencl_render,
	    .download = opencl_download,
	    .upload = opencl_upload,
	    .copy_reserve = opencl_copy_reserve,
	    .copy_release = opencl_copy_release,
	    .copy = opencl_copy,
	    .pin = opencl_pin,
	    .unpin = opencl_unpin,
	    .form = opencl_form,
	};
	*backend = NULL;
	Backend* b = scree_allocate(sizeof *b);
	if (!b)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for an OpenCL device.");
	b->f = &functions;
	b->distant = true;
	b->ordered = true; // bay_solve.cl finds the constraints of a world by their slots
	scree_status status = open_device(b, options, device);
	if (status != SCREE_OK)
		opencl_close(b);
	else
		*backend = b;
	return status;
}

scree_status opencl_open(const BackendOptions* options, Backend** backend)
{
	return gate_open(options, opencl_open_device, backend);
}

scree_status opencl_test(const BackendOptions* options) { return gate_test(options, opencl_open_device); }
