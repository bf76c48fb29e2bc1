// SPDX-License-Identifier: MIT
// readback.c -- reads pools, either at once or into pinned memory while the device continues.
#include "opencl/readback.h"
#include "opencl/buffer.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "opencl/transfer.h"
#include "platform/error.h"
#include <string.h>

#define READ_PART ((size_t)1 << 20) // bytes of a part of a read that waits

// places in the pinned memory of AsyncRead, bytes: destination of opencl_read_begin, of read_edges, of other reads
#define EDGES_AT (READ_ASYNC_BYTES)
#define PART_AT  (READ_ASYNC_BYTES + 64)

scree_status read_open(OpenCl* d) { return pinned_open(d, PART_AT + READ_PART, &d->read.pinned); }

cl_int* read_edges(const OpenCl* d) { return (cl_int*)(d->read.pinned.memory + EDGES_AT); }

void read_close(OpenCl* d)
{
	RELEASE(d->failure, Event, d->read.event);
	pinned_close(d, &d->read.pinned);
}

// Stores counters that were read from the device. Fails if their fault flag states that a spin-wait reached its limit.
static scree_status counters_note(Backend* b, const Counters* counters)
{
	OpenCl* d = b->state;
	d->persistent.last = *counters;
	// tiles are stale if the layout of constraints has changed; a solve that was enqueued before has then done nothing
	d->tiles.stale |= counters->changed || !counters->kept;
	if (!counters->fault)
		return SCREE_OK;
	return fail(SCREE_ERROR_DEVICE_FAILED,
	            "A step on %s failed: its work-groups did not all run at the same time within 2 s. Another program may "
	            "occupy the device; \"cpu\" has no such limit.",
	            b->name);
}

scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	d->read.pool = pool;
	d->read.bytes = bytes * (size_t)count;
	d->read.staged = d->staging.used;
	ASSERT(d->read.bytes <= READ_ASYNC_BYTES && !d->read.event);
	TRY(CALL(d->failure, EnqueueReadBuffer, d->queue, pool_buffer(d, pool), CL_FALSE,
	         pool_offset(d, pool) + bytes * (size_t)first, d->read.bytes, d->read.pinned.memory, 0, NULL,
	         &d->read.event));
	return CALL(d->failure, Flush, d->queue);
}

scree_status opencl_read_end(Backend* b, void* items)
{
	OpenCl* d = b->state;
	TRY(event_wait(d, &d->read.event));
	// if no upload was enqueued after this read was enqueued, all uploads are done
	if (d->staging.used == d->read.staged)
		d->staging.used = 0;
	memcpy(items, d->read.pinned.memory, d->read.bytes);
	return d->read.pool == POOL_counters ? counters_note(b, items) : SCREE_OK;
}

scree_status read_now(OpenCl* d, cl_mem buffer, size_t offset, size_t bytes, void* to)
{
	// the driver would use its own pinned memory, which takes longer
	unsigned char* place = d->read.pinned.memory + PART_AT;
	for (size_t done = 0; done < bytes;)
	{
		size_t part = bytes - done < READ_PART ? bytes - done : READ_PART;
		cl_event event;
		TRY(CALL(d->failure, EnqueueReadBuffer, d->queue, buffer, CL_FALSE, offset + done, part, place, 0, NULL,
		         &event));
		TRY(queue_wait(d, d->queue, &event));
		memcpy((char*)to + done, place, part);
		done += part;
	}
	return SCREE_OK;
}

static scree_status read_pinned(OpenCl* d, cl_mem buffer, size_t offset, size_t bytes, void* to)
{
	cl_event event;
	TRY(CALL(d->failure, EnqueueReadBuffer, d->queue, buffer, CL_FALSE, offset, bytes, to, 0, NULL, &event));
	return queue_wait(d, d->queue, &event);
}

scree_status opencl_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count == 0)
		return SCREE_OK;
	size_t offset = pool_offset(d, pool) + bytes * (size_t)first, all = bytes * (size_t)count;
	if (is_pinned(d, items, all))
		TRY(read_pinned(d, pool_buffer(d, pool), offset, all, items));
	else if (transfer_wanted(d, all))
		TRY(transfer_down(d, pool_buffer(d, pool), offset, items, all));
	else
		TRY(read_now(d, pool_buffer(d, pool), offset, all, items));
	d->staging.used = 0;
	return pool == POOL_counters ? counters_note(b, items) : SCREE_OK;
}
