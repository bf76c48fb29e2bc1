// SPDX-License-Identifier: MIT
// queue.c -- enqueues launches and uploads, waits for the queue, and measures launches.
#include "opencl/queue.h"
#include "platform/error.h"
#include <math.h>
#include <string.h>

#define LAPS        4096
#define UPLOAD_PART (STAGING_BYTES / 4) // bytes of a part of an upload

scree_status timing_open(OpenCl* d)
{
	d->timing.laps = scree_allocate(LAPS * sizeof *d->timing.laps);
	return d->timing.laps ? SCREE_OK
	                      : fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for the timings of an OpenCL device.");
}

// Reads the end of a launch, ns. If other queues use the context, the driver of NVIDIA states up to 5 ms after a wait for
// the queue, clFinish included, that launches have not ended. What they write can be read by then.
static scree_status lap_end(OpenCl* d, const LaunchTime* lap, cl_ulong* end)
{
	cl_int error =
	    CODE(d->failure, GetEventProfilingInfo, lap->event, CL_PROFILING_COMMAND_END, sizeof *end, end, NULL);
	if (error != CL_PROFILING_INFO_NOT_AVAILABLE)
		return context_check(d->failure, "clGetEventProfilingInfo", error);
	TRY(wait_for(d->failure, lap->event, d->wait_limit, d->device.type & CL_DEVICE_TYPE_CPU));
	return CALL(d->failure, GetEventProfilingInfo, lap->event, CL_PROFILING_COMMAND_END, sizeof *end, end, NULL);
}

static scree_status lap_read(OpenCl* d, const LaunchTime* lap)
{
	cl_ulong begin = 0, end = 0; // ns
	TRY(lap_end(d, lap, &end));
	TRY(CALL(d->failure, GetEventProfilingInfo, lap->event, CL_PROFILING_COMMAND_START, sizeof begin, &begin, NULL));
	d->timing.milliseconds[lap->stage] += 1e-6 * (double)(end - begin);
	return SCREE_OK;
}

// Adds the times of all launches if `status` is SCREE_OK, and releases their events. Returns the first failure.
static scree_status add_laps(OpenCl* d, scree_status status)
{
	for (int i = 0; i < d->timing.lap_count; ++i)
	{
		if (status == SCREE_OK)
			status = lap_read(d, &d->timing.laps[i]);
		RELEASE(d->failure, Event, d->timing.laps[i].event);
	}
	d->timing.lap_count = 0;
	return status;
}

scree_status event_wait(OpenCl* d, cl_event* event)
{
	scree_status status = wait_for(d->failure, *event, d->wait_limit, d->device.type & CL_DEVICE_TYPE_CPU);
	RELEASE(d->failure, Event, *event);
	*event = NULL;
	return status;
}

scree_status queue_wait(OpenCl* d, cl_command_queue queue, cl_event* event)
{
	scree_status status = CALL(d->failure, Flush, queue);
	if (status == SCREE_OK)
		return event_wait(d, event);
	RELEASE(d->failure, Event, *event);
	*event = NULL;
	return status;
}

scree_status queue_finish(OpenCl* d, cl_command_queue queue)
{
	if (isinf(d->wait_limit))
		return CALL(d->failure, Finish, queue);
	cl_event event;
	TRY(CALL(d->failure, EnqueueBarrierWithWaitList, queue, 0, NULL, &event));
	return queue_wait(d, queue, &event);
}

scree_status finish(OpenCl* d)
{
	scree_status status = queue_finish(d, d->queue);
	if (status == SCREE_OK)
		d->staging.used = 0;
	return add_laps(d, status);
}

void finish_to_close(OpenCl* d)
{
	if (!context_failed(d->failure) && finish(d) != SCREE_OK)
		log_sentence(SCREE_LOG_WARNING, "%s is closed: %s", d->device.about.name, scree_error());
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
	// memory of the caller is copied first, because the device might read it after a wait that failed
	for (size_t done = 0; done < count;)
	{
		size_t part = count - done < UPLOAD_PART ? count - done : UPLOAD_PART;
		if (d->staging.used + part > STAGING_BYTES)
			TRY(finish(d));
		const void* copied = memcpy(d->staging.pinned.memory + d->staging.used, (const char*)bytes + done, part);
		d->staging.used += part;
		TRY(CALL(d->failure, EnqueueWriteBuffer, d->queue, buffer, CL_FALSE, offset + done, part, copied, 0, NULL,
		         NULL));
		done += part;
	}
	return SCREE_OK;
}

scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group)
{
	if (d->timing.lap_count == LAPS)
		TRY(finish(d));
	cl_event* event = d->timing.laps ? &d->timing.laps[d->timing.lap_count].event : NULL;
	TRY(CALL(d->failure, EnqueueNDRangeKernel, d->queue, kernel, 1, NULL, &items, &group, 0, NULL, event));
	if (event)
		d->timing.laps[d->timing.lap_count++].stage = d->timing.stage;
	return SCREE_OK;
}
