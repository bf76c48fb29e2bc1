// SPDX-License-Identifier: MIT
// held.c -- reads a few items while the device goes on: into pinned memory, waited for by an event of their own.
#include "error.h"
#include "opencl/opencl.h"
#include <string.h>

scree_status held_open(OpenCl* d)
{
	cl_int error;
	cl_mem_flags flags = CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR;
	d->held_buffer = opencl.CreateBuffer(d->context, flags, HELD_BYTES, NULL, &error);
	TRY(opencl_check("clCreateBuffer", error));
	d->held = opencl.EnqueueMapBuffer(d->queue, d->held_buffer, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE, 0, HELD_BYTES, 0,
	                                  NULL, NULL, &error);
	return opencl_check("clEnqueueMapBuffer", error);
}

void held_close(OpenCl* d)
{
	if (d->held_event)
		opencl.ReleaseEvent(d->held_event);
	if (d->held)
	{
		opencl.EnqueueUnmapMemObject(d->queue, d->held_buffer, d->held, 0, NULL, NULL);
		opencl.Finish(d->queue);
	}
	if (d->held_buffer)
		opencl.ReleaseMemObject(d->held_buffer);
}

scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	d->held_bytes = bytes * (size_t)count;
	d->held_staged = d->staged;
	ASSERT(d->held_bytes <= HELD_BYTES && !d->held_event);
	TRY(CALL(EnqueueReadBuffer, d->queue, d->buffers[pool_info[pool].per], CL_FALSE,
	         pool_offset(d, pool) + bytes * (size_t)first, d->held_bytes, d->held, 0, NULL, &d->held_event));
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
	memcpy(items, d->held, d->held_bytes);
	return d->held_bytes == sizeof(Counters) ? opencl_note(b, items) : SCREE_OK;
}
