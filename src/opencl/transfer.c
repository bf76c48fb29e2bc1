// SPDX-License-Identifier: MIT
// transfer.c -- transfers large arrays to and from a GPU, by several threads through pinned memory.
//
// A driver copies a user's array through its own pinned memory with one thread: 7 GB/s on the host of an H200, an
// eighth of the bandwidth of the bus. Here several threads copy one pinned block while the device transfers another.
#include "opencl/transfer.h"
#include "opencl/buffer.h"
#include "opencl/queue.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <string.h>

#define TRANSFER_PART    (TRANSFER_BLOCK / 2) // bytes of a part of the array; the bus is idle until one part is copied
#define TRANSFER_THREADS 6

typedef struct
{
	const Load* loads;
	int count;
} Loads;

static void copy_share(void* context, int block, int blocks)
{
	const Loads* all = context;
	for (int k = 0; k < all->count; ++k)
	{
		const Load* load = &all->loads[k];
		size_t share = (load->bytes / (size_t)blocks + 63) / 64 * 64, begin = share * (size_t)block;
		if (begin >= load->bytes)
			continue;
		size_t left = load->bytes - begin;
		memcpy((char*)load->to + begin, (const char*)load->from + begin, left < share ? left : share);
	}
}

void transfer_copy(OpenCl* d, const Load* loads, int count)
{
	threads_run_once(d->transfer.threads, copy_share, &(Loads){loads, count});
}

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

bool transfer_wanted(const OpenCl* d, size_t count)
{
	return count > TRANSFER_PART && !(d->device.type & CL_DEVICE_TYPE_CPU);
}

scree_status transfer_open(OpenCl* d)
{
	Transfer* c = &d->transfer;
	int cores = processor_cores();
	if (!c->pinned.memory)
		TRY(pinned_open(d, TRANSFER_BLOCKS * TRANSFER_BLOCK, &c->pinned));
	if (!c->threads)
		c->threads =
		    threads_open(cores < TRANSFER_THREADS ? cores : TRANSFER_THREADS, c->tasks.enqueue ? &c->tasks : NULL);
	return c->threads ? SCREE_OK : SCREE_ERROR_OUT_OF_MEMORY;
}

unsigned char* transfer_block(const OpenCl* d, int block)
{
	return d->transfer.pinned.memory + TRANSFER_BLOCK * (size_t)block;
}

scree_status transfer_settle(OpenCl* d, int block)
{
	cl_event* event = &d->transfer.events[block];
	if (!*event)
		return SCREE_OK;
	return event_wait(d, event);
}

scree_status transfer_send(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                           size_t bytes)
{
	TRY(CALL(d->failure, EnqueueWriteBuffer, queue, buffer, CL_FALSE, offset, bytes, transfer_block(d, block),
	         wait ? 1 : 0, wait ? &wait : NULL, &d->transfer.events[block]));
	return CALL(d->failure, Flush, queue);
}

scree_status transfer_fetch(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                            size_t bytes)
{
	TRY(CALL(d->failure, EnqueueReadBuffer, queue, buffer, CL_FALSE, offset, bytes, transfer_block(d, block),
	         wait ? 1 : 0, wait ? &wait : NULL, &d->transfer.events[block]));
	return CALL(d->failure, Flush, queue);
}

scree_status transfer_up(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count)
{
	TRY(transfer_open(d));
	int block = 0;
	for (size_t at = 0; at < count; at += TRANSFER_PART, block ^= 1)
	{
		Load load = {transfer_block(d, block), (const char*)bytes + at, smaller(TRANSFER_PART, count - at)};
		TRY(transfer_settle(d, block));
		transfer_copy(d, &load, 1);
		TRY(transfer_send(d, d->queue, NULL, block, buffer, offset + at, load.bytes));
	}
	return SCREE_OK;
}

scree_status transfer_down(OpenCl* d, cl_mem buffer, size_t offset, void* bytes, size_t count)
{
	TRY(transfer_open(d));
	int parts = (int)((count + TRANSFER_PART - 1) / TRANSFER_PART);
	for (int k = 0; k <= parts; ++k)
	{
		size_t at = TRANSFER_PART * (size_t)k;
		if (k < parts)
		{
			TRY(transfer_settle(d, k & 1));
			TRY(transfer_fetch(d, d->queue, NULL, k & 1, buffer, offset + at, smaller(TRANSFER_PART, count - at)));
		}
		if (k == 0)
			continue;
		size_t before = at - TRANSFER_PART;
		TRY(transfer_settle(d, (k - 1) & 1));
		transfer_copy(
		    d, &(Load){(char*)bytes + before, transfer_block(d, (k - 1) & 1), smaller(TRANSFER_PART, count - before)},
		    1);
	}
	return SCREE_OK;
}

void transfer_close(OpenCl* d)
{
	for (int block = 0; block < TRANSFER_BLOCKS; ++block)
		RELEASE(d->failure, Event, d->transfer.events[block]);
	threads_close(d->transfer.threads);
	pinned_close(d, &d->transfer.pinned);
}
