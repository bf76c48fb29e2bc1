// SPDX-License-Identifier: MIT
// read_async.c -- pinned memory; reads a few items into it while the device goes on, waited for by an event of their own.
#include "opencl/opencl.h"
#include "platform/error.h"
#include <string.h>

scree_status pinned_open(OpenCl* d, size_t bytes, Pinned* pinned)
{
	cl_int error;
	cl_mem_flags flags = CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR;
	pinned->buffer = opencl.CreateBuffer(d->context, flags, bytes, NULL, &error);
	TRY(opencl_check("clCreateBuffer", error));
	pinned->memory = opencl.EnqueueMapBuffer(d->queue, pinned->buffer, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE, 0, bytes, 0,
	                                         NULL, NULL, &error);
	return opencl_check("clEnqueueMapBuffer", error);
}

void pinned_close(OpenCl* d, Pinned* pinned)
{
	if (pinned->memory)
	{
		opencl.EnqueueUnmapMemObject(d->queue, pinned->buffer, pinned->memory, 0, NULL, NULL);
		opencl.Finish(d->queue);
	}
	if (pinned->buffer)
		opencl.ReleaseMemObject(pinned->buffer);
}

void held_close(OpenCl* d)
{
	if (d->held_event)
		opencl.ReleaseEvent(d->held_event);
	pinned_close(d, &d->held);
}

scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	d->held_bytes = bytes * (size_t)count;
	d->held_staged = d->staged;
	ASSERT(d->held_bytes <= READ_ASYNC_BYTES && !d->held_event);
	TRY(CALL(EnqueueReadBuffer, d->queue, d->buffers[pool_info[pool].per], CL_FALSE,
	         pool_offset(d, pool) + bytes * (size_t)first, d->held_bytes, d->held.memory, 0, NULL, &d->held_event));
	return CALL(Flush, d->queue);
}

scree_status opencl_read_end(Backend* b, void* items)
{
	OpenCl* d = b->state;
	TRY(CALL(WaitForEvents, 1, &d->held_event));
	opencl.ReleaseEvent(d->held_event);
	d->held_event = NULL;
	// uploads before the copy are done
	if (d->staged == d->held_staged)
		d->staged = 0;
	memcpy(items, d->held.memory, d->held_bytes);
	return d->held_bytes == sizeof(Counters) ? opencl_note(b, items) : SCREE_OK;
}
