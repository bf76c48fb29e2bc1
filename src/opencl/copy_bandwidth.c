// SPDX-License-Identifier: MIT
// copy_bandwidth.c -- copies blocks within device memory, to measure bandwidth.
#include "opencl/copy_bandwidth.h"
#include "opencl/buffer.h"
#include "opencl/queue.h"
#include "platform/error.h"

void opencl_copy_release(Backend* b)
{
	OpenCl* d = b->state;
	for (int k = 0; k < 2; ++k)
	{
		RELEASE(d->failure, MemObject, d->copy.buffers[k]);
		d->copy.buffers[k] = NULL;
	}
}

scree_status opencl_copy_reserve(Backend* b, size_t bytes)
{
	OpenCl* d = b->state;
	opencl_copy_release(b);
	if (b->bytes + 2 * (uint64_t)bytes > d->device.about.memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s has no room for two blocks of %zu bytes.", b->name, bytes);
	d->copy.bytes = bytes;
	for (int k = 0; k < 2; ++k)
		TRY(buffer_create(d, bytes, &d->copy.buffers[k]));
	return finish(d); // drivers that allocate on first use fail in this call
}

scree_status opencl_copy(Backend* b, int times)
{
	OpenCl* d = b->state;
	for (int k = 0; k < times; ++k)
		TRY(CALL(d->failure, EnqueueCopyBuffer, d->queue, d->copy.buffers[0], d->copy.buffers[1], 0, 0, d->copy.bytes,
		         0, NULL, NULL));
	return finish(d);
}
