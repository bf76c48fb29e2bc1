// SPDX-License-Identifier: MIT
// queue.c -- enqueues launches and uploads, waits for the queue, and measures launches.
#include "opencl/queue.h"
#include "platform/error.h"
#include <string.h>

#define LAPS 4096

scree_status timing_open(OpenCl* d)
{
	d->timing.laps = scree_allocate(LAPS * sizeof *d->timing.laps);
	return d->timing.laps ? SCREE_OK
	                      : fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for the timings of an OpenCL device.");
}

static void add_laps(OpenCl* d)
{
	for (int i = 0; i < d->timing.lap_count; ++i)
	{
		cl_ulong begin = 0, end = 0; // ns
		opencl.GetEventProfilingInfo(d->timing.laps[i].event, CL_PROFILING_COMMAND_START, sizeof begin, &begin, NULL);
		opencl.GetEventProfilingInfo(d->timing.laps[i].event, CL_PROFILING_COMMAND_END, sizeof end, &end, NULL);
		opencl.ReleaseEvent(d->timing.laps[i].event);
		d->timing.milliseconds[d->timing.laps[i].stage] += 1e-6 * (double)(end - begin);
	}
	d->timing.lap_count = 0;
}

scree_status finish(OpenCl* d)
{
	scree_status status = CALL(Finish, d->queue);
	d->staging.used = 0;
	add_laps(d);
	return status;
}

scree_status opencl_timings(Backend* b, double milliseconds[STAGE_COUNT])
{
	OpenCl* d = b->state;
	TRY(finish(d));
	memcpy(milliseconds, d->timing.milliseconds, sizeof d->timing.milliseconds);
	memset(d->timing.milliseconds, 0, sizeof d->timing.milliseconds);
	return SCREE_OK;
}

scree_status upload(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count)
{
	bool small = count <= STAGING_BYTES / 4;
	if (small)
	{
		if (d->staging.used + count > STAGING_BYTES)
			TRY(finish(d));
		bytes = memcpy(d->staging.pinned.memory + d->staging.used, bytes, count);
		d->staging.used += count;
	}
	TRY(CALL(EnqueueWriteBuffer, d->queue, buffer, small ? CL_FALSE : CL_TRUE, offset, count, bytes, 0, NULL, NULL));
	if (!small)
		d->staging.used = 0;
	return SCREE_OK;
}

scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group)
{
	if (d->timing.lap_count == LAPS)
		TRY(finish(d));
	cl_event* event = d->timing.laps ? &d->timing.laps[d->timing.lap_count].event : NULL;
	TRY(CALL(EnqueueNDRangeKernel, d->queue, kernel, 1, NULL, &items, &group, 0, NULL, event));
	if (event)
		d->timing.laps[d->timing.lap_count++].stage = d->timing.stage;
	return SCREE_OK;
}
