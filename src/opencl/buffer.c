// SPDX-License-Identifier: MIT
// buffer.c -- creates scratch buffers, pinned memory and other buffers that are not pools.
#include "opencl/buffer.h"
#include "opencl/queue.h"
#include "platform/error.h"

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
	// drivers that allocate on first use fail in the fill, each with a different error code
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

void scratch_release(Scratch* scratch)
{
	if (scratch->buffer)
		opencl.ReleaseMemObject(scratch->buffer);
	*scratch = (Scratch){0};
}

scree_status scratch_drop(OpenCl* d, Scratch* const* scratch, int count)
{
	TRY(finish(d));
	for (int k = 0; k < count; ++k)
	{
		d->backend->bytes -= scratch[k]->bytes;
		scratch_release(scratch[k]);
	}
	return SCREE_OK;
}

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
