// SPDX-License-Identifier: MIT
// buffer.c -- creates scratch buffers, pinned memory and other buffers that are not pools.
#include "opencl/buffer.h"
#include "opencl/queue.h"
#include "platform/error.h"

// Returns the status of a call that allocates memory. CL_OUT_OF_RESOURCES is no lack of memory, because NVIDIA also
// returns it for a context that is lost.
static scree_status buffer_status(OpenCl* d, const char* function, size_t bytes, cl_int error)
{
	if (error == CL_MEM_OBJECT_ALLOCATION_FAILURE || error == CL_OUT_OF_HOST_MEMORY || error == CL_INVALID_BUFFER_SIZE)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s has no memory for a buffer of %zu bytes: %s: %s (%d)",
		            d->device.about.name, bytes, function, opencl_error_name(error), (int)error);
	return context_check(d->failure, function, error);
}

scree_status buffer_create(OpenCl* d, size_t bytes, cl_mem* buffer)
{
	const char* function = "clCreateBuffer";
	const cl_int zero = 0;
	cl_int error;
	CREATE(d->failure, *buffer, error, Buffer, d->context, CL_MEM_READ_WRITE, bytes, NULL);
	if (!error)
	{
		// drivers that allocate on first use fail in the fill
		function = "clEnqueueFillBuffer";
		error = opencl.EnqueueFillBuffer(d->queue, *buffer, &zero, sizeof zero, 0, bytes, 0, NULL, NULL);
	}
	if (error)
	{
		context_note(d->failure, error);
		RELEASE(d->failure, MemObject, *buffer);
		*buffer = NULL;
	}
	return buffer_status(d, function, bytes, error);
}

scree_status scratch_reserve(OpenCl* d, Scratch* scratch, size_t bytes)
{
	if (bytes <= scratch->bytes)
		return SCREE_OK;
	TRY(finish(d));
	d->backend->bytes -= scratch->bytes;
	scratch_release(d, scratch);
	bytes = (bytes + bytes / 8 + 15) / 16 * 16;
	TRY(buffer_create(d, bytes, &scratch->buffer));
	scratch->bytes = bytes;
	d->backend->bytes += bytes;
	return SCREE_OK;
}

void scratch_release(OpenCl* d, Scratch* scratch)
{
	RELEASE(d->failure, MemObject, scratch->buffer);
	*scratch = (Scratch){0};
}

scree_status scratch_drop(OpenCl* d, Scratch* const* scratch, int count)
{
	TRY(finish(d));
	for (int k = 0; k < count; ++k)
	{
		d->backend->bytes -= scratch[k]->bytes;
		scratch_release(d, scratch[k]);
	}
	return SCREE_OK;
}

scree_status pinned_open(OpenCl* d, size_t bytes, Pinned* pinned)
{
	cl_int error;
	cl_mem_flags flags = CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR;
	cl_event event;
	CREATE(d->failure, pinned->buffer, error, Buffer, d->context, flags, bytes, NULL);
	TRY(buffer_status(d, "clCreateBuffer", bytes, error));
	void* memory = opencl.EnqueueMapBuffer(d->queue, pinned->buffer, CL_FALSE, CL_MAP_READ | CL_MAP_WRITE, 0, bytes, 0,
	                                       NULL, &event, &error);
	TRY(buffer_status(d, "clEnqueueMapBuffer", bytes, error));
	pinned->memory = memory;
	return queue_wait(d, d->queue, &event);
}

void pinned_close(OpenCl* d, Pinned* pinned)
{
	if (pinned->memory)
	{
		if (!context_failed(d->failure))
			context_released(d->failure, "clEnqueueUnmapMemObject",
			                 opencl.EnqueueUnmapMemObject(d->queue, pinned->buffer, pinned->memory, 0, NULL, NULL));
		finish_to_close(d);
	}
	RELEASE(d->failure, MemObject, pinned->buffer);
}

scree_status opencl_pin(Backend* b, size_t bytes, void** memory)
{
	OpenCl* d = b->state;
	int k = 0;
	while (d->pinned[k].memory)
		++k;
	ASSERT(k < PINNED_MOST);
	TRY(pinned_open(d, bytes, d->pinned + k));
	d->pinned_bytes[k] = bytes;
	*memory = d->pinned[k].memory;
	return SCREE_OK;
}

void opencl_unpin(Backend* b, void* memory)
{
	OpenCl* d = b->state;
	for (int k = 0; k < PINNED_MOST; ++k)
		if (memory && d->pinned[k].memory == memory)
		{
			pinned_close(d, d->pinned + k);
			d->pinned[k] = (Pinned){0};
		}
}

bool is_pinned(const OpenCl* d, const void* at, size_t bytes)
{
	if (d->beside && d->beside->context == d->context && is_pinned(d->beside, at, bytes))
		return true;
	uintptr_t first = (uintptr_t)at;
	for (int k = 0; k < PINNED_MOST; ++k)
	{
		uintptr_t begin = (uintptr_t)d->pinned[k].memory;
		if (begin && first >= begin && first + bytes <= begin + d->pinned_bytes[k])
			return true;
	}
	return false;
}
