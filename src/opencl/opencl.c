// SPDX-License-Identifier: MIT
// opencl.c -- the OpenCL backend: one buffer a pool, one kernel a stage, one queue in order.
#include "opencl/opencl.h"
#include "error.h"
#include "opencl/program.h"
#include <stdio.h>

// written by cmake/embed.cmake
extern const char opencl_program[];
extern const size_t opencl_program_length;

static void opencl_close(Backend* b)
{
	OpenCl* d = b->state;
	if (d)
	{
		if (d->queue)
			finish(d); // a failure changes nothing now
		persistent_close(d);
		primitives_close(d);
		for (int i = 0; i < STAGE_COUNT; ++i)
			if (d->stages[i].kernel)
				opencl.ReleaseKernel(d->stages[i].kernel);
		for (int i = 0; i < POOL_COUNT; ++i)
			if (d->pools[i])
				opencl.ReleaseMemObject(d->pools[i]);
		if (d->program)
			opencl.ReleaseProgram(d->program);
		if (d->queue)
			opencl.ReleaseCommandQueue(d->queue);
		if (d->context)
			opencl.ReleaseContext(d->context);
		scree_release(d->laps);
		scree_release(d->staging);
		scree_release(d);
	}
	scree_release(b);
}

// Makes a larger copy of a pool, zero behind what it held. The old one is still in use.
static scree_status pool_grow(OpenCl* d, PoolId pool, int old_capacity, int capacity, cl_mem* grown)
{
	size_t old_bytes = pool_info[pool].bytes * (size_t)old_capacity;
	TRY(buffer_create(d, pool_info[pool].bytes * (size_t)capacity, grown));
	if (old_bytes == 0)
		return SCREE_OK;
	return CALL(EnqueueCopyBuffer, d->queue, d->pools[pool], *grown, 0, 0, old_bytes, 0, NULL, NULL);
}

static scree_status opencl_resize(Backend* b, Per per, int capacity)
{
	OpenCl* d = b->state;
	int old = b->capacity[per];
	if (capacity <= old)
		return SCREE_OK;

	// while they are copied, both sizes are held
	uint64_t larger = 0, smaller = 0;
	for (int i = 0; i < POOL_COUNT; ++i)
		if (pool_info[i].per == per)
		{
			larger += (uint64_t)capacity * pool_info[i].bytes;
			smaller += (uint64_t)old * pool_info[i].bytes;
		}
	if (b->bytes + larger > d->device.about.memory)
		return fail(SCREE_OUT_OF_MEMORY, "%s has %llu MB; pools of %llu MB and their growth by %llu MB do not fit.",
		            b->name, (unsigned long long)(d->device.about.memory >> 20), (unsigned long long)(b->bytes >> 20),
		            (unsigned long long)(larger >> 20));

	cl_mem grown[POOL_COUNT] = {0};
	scree_status status = SCREE_OK;
	for (int i = 0; i < POOL_COUNT && status == SCREE_OK; ++i)
		if (pool_info[i].per == per)
			status = pool_grow(d, (PoolId)i, old, capacity, &grown[i]);
	if (status == SCREE_OK)
		status = finish(d); // drivers that allocate late say so by now
	for (int i = 0; i < POOL_COUNT; ++i)
		if (grown[i])
		{
			cl_mem dropped = grown[i];
			if (status == SCREE_OK)
			{
				dropped = d->pools[i];
				d->pools[i] = grown[i];
			}
			opencl.ReleaseMemObject(dropped);
		}
	if (status != SCREE_OK)
		return status;
	b->capacity[per] = capacity;
	b->bytes += larger - smaller;
	return kernels_bind(d, per);
}

static scree_status opencl_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count == 0)
		return SCREE_OK;
	return upload(d, d->pools[pool], bytes * (size_t)first, items, bytes * (size_t)count);
}

static scree_status opencl_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count == 0)
		return SCREE_OK;
	TRY(CALL(EnqueueReadBuffer, d->queue, d->pools[pool], CL_TRUE, bytes * (size_t)first, bytes * (size_t)count, items,
	         0, NULL, NULL));
	d->staged = 0;
	if (pool == POOL_counters && ((const Counters*)items)->fault)
		return fail(SCREE_DEVICE_FAILED,
		            "The work-groups of %s did not meet in the solver (SCREE_PERSISTENT=0 avoids it).", b->name);
	return SCREE_OK;
}

static scree_status opencl_wait(Backend* b) { return finish(b->state); }

static scree_status open_device(Backend* b, const BackendOptions* options)
{
	OpenCl* d = b->state = scree_allocate(sizeof *d);
	if (!d)
		return fail(SCREE_OUT_OF_MEMORY, "There is no memory for an OpenCL device.");
	TRY(device_choose(options, &d->device));
	snprintf(b->name, sizeof b->name, "%s", d->device.about.name);
	TRY(staging_open(d, options->timings));

	cl_int error;
	cl_context_properties properties[] = {CL_CONTEXT_PLATFORM, (cl_context_properties)d->device.platform, 0};
	d->context = opencl.CreateContext(properties, 1, &d->device.id, NULL, NULL, &error);
	TRY(opencl_check("clCreateContext", error));
	d->queue =
	    opencl.CreateCommandQueue(d->context, d->device.id, options->timings ? CL_QUEUE_PROFILING_ENABLE : 0, &error);
	TRY(opencl_check("clCreateCommandQueue", error));
	TRY(program_build(d->context, &d->device, opencl_program, opencl_program_length, &d->program));

	// a pool without items is one item all the same: kernels need something to point at
	for (int i = 0; i < POOL_COUNT; ++i)
		TRY(buffer_create(d, pool_info[i].bytes, &d->pools[i]));
	for (int i = 0; i < STAGE_COUNT; ++i)
		TRY(kernel_create(d, stage_names[i], STAGE_GROUP, &d->stages[i]));
	TRY(primitives_open(d));
	TRY(persistent_open(d));
	return finish(d);
}

scree_status opencl_open(const BackendOptions* options, Backend** backend)
{
	static const BackendFunctions functions = {
	    .close = opencl_close,
	    .resize = opencl_resize,
	    .run = opencl_run,
	    .write = opencl_write,
	    .read = opencl_read,
	    .wait = opencl_wait,
	    .timings = opencl_timings,
	};
	*backend = NULL;
	Backend* b = scree_allocate(sizeof *b);
	if (!b)
		return fail(SCREE_OUT_OF_MEMORY, "There is no memory for an OpenCL device.");
	b->f = &functions;
	scree_status status = open_device(b, options);
	if (status != SCREE_OK)
		opencl_close(b);
	else
		*backend = b;
	return status;
}
