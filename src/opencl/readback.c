// SPDX-License-Identifier: MIT
// readback.c -- reads pools, either at once or into pinned memory while the device continues.
#include "opencl/readback.h"
#include "opencl/buffer.h"
#include "opencl/launch.h"
#include "opencl/transfer.h"
#include "platform/error.h"
#include <string.h>

scree_status read_open(OpenCl* d) { return pinned_open(d, READ_ASYNC_BYTES, &d->read.pinned); }

void read_close(OpenCl* d)
{
	if (d->read.event)
		opencl.ReleaseEvent(d->read.event);
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
	TRY(CALL(EnqueueReadBuffer, d->queue, pool_buffer(d, pool), CL_FALSE, pool_offset(d, pool) + bytes * (size_t)first,
	         d->read.bytes, d->read.pinned.memory, 0, NULL, &d->read.event));
	return CALL(Flush, d->queue);
}

scree_status opencl_read_end(Backend* b, void* items)
{
	OpenCl* d = b->state;
	TRY(CALL(WaitForEvents, 1, &d->read.event));
	opencl.ReleaseEvent(d->read.event);
	d->read.event = NULL;
	// if no upload was enqueued after this read was enqueued, all uploads are done
	if (d->staging.used == d->read.staged)
		d->staging.used = 0;
	memcpy(items, d->read.pinned.memory, d->read.bytes);
	return d->read.pool == POOL_counters ? counters_note(b, items) : SCREE_OK;
}

scree_status opencl_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	OpenCl* d = b->state;
	size_t bytes = pool_info[pool].bytes;
	ASSERT(first >= 0 && count >= 0 && first <= b->capacity[pool_info[pool].per] - count);
	if (count == 0)
		return SCREE_OK;
	size_t offset = pool_offset(d, pool) + bytes * (size_t)first, all = bytes * (size_t)count;
	// small reads go through pinned memory; otherwise the driver would use its own pinned memory, which takes longer
	if (all <= READ_ASYNC_BYTES && !d->read.event)
	{
		TRY(opencl_read_begin(b, pool, first, count));
		return opencl_read_end(b, items);
	}
	if (transfer_wanted(d, all))
		TRY(transfer_down(d, pool_buffer(d, pool), offset, items, all));
	else
		TRY(CALL(EnqueueReadBuffer, d->queue, pool_buffer(d, pool), CL_TRUE, offset, all, items, 0, NULL, NULL));
	d->staging.used = 0;
	return pool == POOL_counters ? counters_note(b, items) : SCREE_OK;
}
