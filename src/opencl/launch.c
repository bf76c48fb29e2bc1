// SPDX-License-Identifier: MIT
// launch.c -- works through lists of runs: launches, uploads and their times.
#include "opencl/opencl.h"
#include "platform/error.h"
#include <string.h>

// A launch is given at most this many groups a compute unit, which fills any device; its items stride over the rest.
#define GROUPS_A_UNIT 64

// The changes of 4,000 bodies that are made anew in a step are 1 MB. Larger uploads wait until the device has read them.
#define STAGING_BYTES ((size_t)8 << 20)
#define LAPS          4096

scree_status staging_open(OpenCl* d, bool timings)
{
	d->laps = timings ? scree_allocate(LAPS * sizeof *d->laps) : NULL;
	if (timings && !d->laps)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for the timings of an OpenCL device.");
	return pinned_open(d, STAGING_BYTES, &d->staging);
}

static void add_laps(OpenCl* d)
{
	for (int i = 0; i < d->lap_count; ++i)
	{
		cl_ulong begin = 0, end = 0; // ns
		opencl.GetEventProfilingInfo(d->laps[i].event, CL_PROFILING_COMMAND_START, sizeof begin, &begin, NULL);
		opencl.GetEventProfilingInfo(d->laps[i].event, CL_PROFILING_COMMAND_END, sizeof end, &end, NULL);
		opencl.ReleaseEvent(d->laps[i].event);
		d->milliseconds[d->laps[i].box] += 1e-6 * (double)(end - begin);
	}
	d->lap_count = 0;
}

scree_status finish(OpenCl* d)
{
	scree_status status = CALL(Finish, d->queue);
	d->staged = 0;
	add_laps(d);
	return status;
}

scree_status opencl_timings(Backend* b, double milliseconds[BOX_COUNT])
{
	OpenCl* d = b->state;
	TRY(finish(d));
	memcpy(milliseconds, d->milliseconds, sizeof d->milliseconds);
	memset(d->milliseconds, 0, sizeof d->milliseconds);
	return SCREE_OK;
}

scree_status upload(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count)
{
	bool small = count <= STAGING_BYTES / 4;
	if (small)
	{
		if (d->staged + count > STAGING_BYTES)
			TRY(finish(d));
		bytes = memcpy(d->staging.memory + d->staged, bytes, count);
		d->staged += count;
	}
	TRY(CALL(EnqueueWriteBuffer, d->queue, buffer, small ? CL_FALSE : CL_TRUE, offset, count, bytes, 0, NULL, NULL));
	if (!small)
		d->staged = 0;
	return SCREE_OK;
}

scree_status buffer_create(OpenCl* d, size_t bytes, cl_mem* buffer)
{
	cl_int error;
	*buffer = opencl.CreateBuffer(d->context, CL_MEM_READ_WRITE, bytes, NULL, &error);
	if (error)
		*buffer = NULL;
	else
	{
		const cl_int zero = 0;
		error = opencl.EnqueueFillBuffer(d->queue, *buffer, &zero, sizeof zero, 0, bytes, 0, NULL, NULL);
	}
	// drivers that allocate on first use fail here with codes of their own choice
	if (error == CL_MEM_OBJECT_ALLOCATION_FAILURE || error == CL_OUT_OF_RESOURCES || error == CL_OUT_OF_HOST_MEMORY ||
	    error == CL_INVALID_BUFFER_SIZE)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s has no room for a buffer of %zu bytes: %s (%d).",
		            d->device.about.name, bytes, opencl_error_name(error), (int)error);
	return opencl_check("clCreateBuffer", error);
}

scree_status scratch_reserve(OpenCl* d, Scratch* scratch, size_t bytes)
{
	if (bytes <= scratch->bytes)
		return SCREE_OK;
	TRY(finish(d));
	d->backend->bytes -= scratch->bytes;
	scratch_release(scratch);
	bytes = (bytes + bytes / 8 + 15) / 16 * 16;
	TRY(buffer_create(d, bytes, &scratch->buffer));
	scratch->bytes = bytes;
	d->backend->bytes += bytes;
	return SCREE_OK;
}

scree_status scratch_drop(OpenCl* d)
{
	Scratch* scratch[TILE_BUFFERS + 3] = {&d->rows, &d->stream, &d->parts};
	for (int k = 0; k < TILE_BUFFERS; ++k)
		scratch[k + 3] = &d->tiles.buffers[k];
	TRY(finish(d));
	for (int k = 0; k < TILE_BUFFERS + 3; ++k)
	{
		d->backend->bytes -= scratch[k]->bytes;
		scratch_release(scratch[k]);
	}
	d->tiles.stale = true;
	return SCREE_OK;
}

void scratch_release(Scratch* scratch)
{
	if (scratch->buffer)
		opencl.ReleaseMemObject(scratch->buffer);
	*scratch = (Scratch){0};
}

scree_status kernel_create(OpenCl* d, const char* name, size_t largest, Kernel* kernel)
{
	cl_int error;
	kernel->kernel = opencl.CreateKernel(d->program, name, &error);
	if (error)
		return fail(SCREE_ERROR_DEVICE_FAILED, "clCreateKernel of %s: %s (%d)", name, opencl_error_name(error),
		            (int)error);
	size_t most = 1, multiple = 1;
	TRY(CALL(GetKernelWorkGroupInfo, kernel->kernel, d->device.id, CL_KERNEL_WORK_GROUP_SIZE, sizeof most, &most,
	         NULL));
	TRY(CALL(GetKernelWorkGroupInfo, kernel->kernel, d->device.id, CL_KERNEL_PREFERRED_WORK_GROUP_SIZE_MULTIPLE,
	         sizeof multiple, &multiple, NULL));
	kernel->group = most < largest ? most : largest;
	if (multiple > 1 && kernel->group > multiple)
		kernel->group -= kernel->group % multiple;
	return SCREE_OK;
}

size_t pool_offset(const OpenCl* d, PoolId pool) { return d->before[pool] * (size_t)d->room[pool_info[pool].per]; }

scree_status kernel_bind(OpenCl* d, Per per, const Kernel* kernel)
{
	int rooms[PER_COUNT];
	for (int i = 0; i < PER_COUNT; ++i)
		rooms[d->argument[i]] = d->room[i];
	TRY(CALL(SetKernelArg, kernel->kernel, (cl_uint)d->argument[per], sizeof(cl_mem), &d->buffers[per]));
	return CALL(SetKernelArg, kernel->kernel, ARGUMENT_ROOMS, sizeof rooms, rooms);
}

scree_status kernels_bind(OpenCl* d, Per per)
{
	for (int k = 0; k < STAGE_COUNT; ++k)
		TRY(kernel_bind(d, per, &d->stages[k]));
	if (d->together)
	{
		TRY(kernel_bind(d, per, &d->persistent));
		TRY(kernel_bind(d, per, &d->relay));
		TRY(kernel_bind(d, per, &d->relay_plain));
		TRY(kernel_bind(d, per, &d->relay_hubs));
		TRY(kernel_bind(d, per, &d->solve_end));
		TRY(tiles_bind(d, per));
	}
	return primitives_bind(d);
}

void step_set(OpenCl* d, const Step* step)
{
	if (memcmp(&d->step, step, sizeof *step) == 0)
		return;
	d->step = *step;
	++d->step_version;
}

scree_status kernel_step(OpenCl* d, Kernel* kernel)
{
	if (kernel->version == d->step_version)
		return SCREE_OK;
	TRY(CALL(SetKernelArg, kernel->kernel, ARGUMENT_STEP, sizeof d->step, &d->step));
	kernel->version = d->step_version;
	return SCREE_OK;
}

scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group)
{
	if (d->lap_count == LAPS)
		TRY(finish(d));
	cl_event* event = d->laps ? &d->laps[d->lap_count].event : NULL;
	TRY(CALL(EnqueueNDRangeKernel, d->queue, kernel, 1, NULL, &items, &group, 0, NULL, event));
	if (event)
		d->laps[d->lap_count++].box = d->box;
	return SCREE_OK;
}

scree_status stage_run(OpenCl* d, const Run* run) { return stage_run_within(d, run, GROUPS_A_UNIT); }

scree_status stage_run_within(OpenCl* d, const Run* run, size_t groups_a_unit)
{
	Kernel* kernel = &d->stages[run->stage];
	d->box = stage_boxes[run->stage];
	TRY(kernel_step(d, kernel));
	TRY(CALL(SetKernelArg, kernel->kernel, ARGUMENT_RUN, sizeof *run, run));
	size_t items = (size_t)(run->end - run->begin);
	size_t groups = stage_widths[run->stage] == WIDTH_GROUP ? items : (items + kernel->group - 1) / kernel->group;
	size_t most = (size_t)d->device.about.units * groups_a_unit;
	return launch(d, kernel->kernel, (groups < most ? groups : most) * kernel->group, kernel->group);
}

static scree_status one_run(OpenCl* d, const Run* run)
{
	if (run->begin >= run->end)
		return SCREE_OK;
	return run->stage < STAGE_COUNT ? stage_run(d, run) : primitive_run(d, run);
}

scree_status opencl_run(Backend* b, const Step* step, const Run* runs, int count)
{
	OpenCl* d = b->state;
	step_set(d, step);
	// the user's changes may give a body another mass, and leaves of a new order make better tiles
	for (int i = 0; i < count; ++i)
		d->tiles.stale |= runs[i].stage == STAGE_command || runs[i].stage == STAGE_tree_order;
	for (int i = 0; i < count;)
	{
		int together = persistent_length(d, runs + i, count - i);
		TRY(together ? persistent_run(d, runs + i, together) : one_run(d, runs + i));
		i += together ? together : 1;
	}
	return CALL(Flush, d->queue);
}
