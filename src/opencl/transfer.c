// SPDX-License-Identifier: MIT
// transfer.c -- large arrays to and from a GPU: by several threads through pinned memory.
//
// A driver copies an array of the user through pinned memory of its own, with one thread: 7 GB/s on the host of an H200, an eighth of
// what the bus can do. Here several threads copy one block of pinned memory while the device transfers another one.
#include "opencl/transfer.h"
#include "opencl/buffer.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <string.h>

// bytes of a part of an array: while the first one is copied to its block, the bus is idle
#define CARRY_PART    (CARRY_BLOCK / 2)
#define CARRY_THREADS 6

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

void carry_copy(OpenCl* d, const Load* loads, int count)
{
	threads_run_once(d->carry.threads, copy_share, &(Loads){loads, count});
}

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

bool carry_wanted(const OpenCl* d, size_t count)
{
	return count > CARRY_PART && !(d->device.type & CL_DEVICE_TYPE_CPU);
}

scree_status carry_open(OpenCl* d)
{
	Carry* c = &d->carry;
	int cores = processor_cores();
	if (!c->pinned.memory)
		TRY(pinned_open(d, CARRY_BLOCKS * CARRY_BLOCK, &c->pinned));
	if (!c->threads)
		c->threads = threads_open(cores < CARRY_THREADS ? cores : CARRY_THREADS);
	return c->threads ? SCREE_OK : SCREE_ERROR_OUT_OF_MEMORY;
}

unsigned char* carry_block(const OpenCl* d, int block) { return d->carry.pinned.memory + CARRY_BLOCK * (size_t)block; }

scree_status carry_settle(OpenCl* d, int block)
{
	cl_event* event = &d->carry.events[block];
	if (!*event)
		return SCREE_OK;
	scree_status status = CALL(WaitForEvents, 1, event);
	opencl.ReleaseEvent(*event);
	*event = NULL;
	return status;
}

scree_status carry_send(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                        size_t bytes)
{
	TRY(CALL(EnqueueWriteBuffer, queue, buffer, CL_FALSE, offset, bytes, carry_block(d, block), wait ? 1 : 0,
	         wait ? &wait : NULL, &d->carry.events[block]));
	return CALL(Flush, queue);
}

scree_status carry_fetch(OpenCl* d, cl_command_queue queue, cl_event wait, int block, cl_mem buffer, size_t offset,
                         size_t bytes)
{
	TRY(CALL(EnqueueReadBuffer, queue, buffer, CL_FALSE, offset, bytes, carry_block(d, block), wait ? 1 : 0,
	         wait ? &wait : NULL, &d->carry.events[block]));
	return CALL(Flush, queue);
}

scree_status carry_up(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count)
{
	TRY(carry_open(d));
	int block = 0;
	for (size_t at = 0; at < count; at += CARRY_PART, block ^= 1)
	{
		Load load = {carry_block(d, block), (const char*)bytes + at, smaller(CARRY_PART, count - at)};
		TRY(carry_settle(d, block));
		carry_copy(d, &load, 1);
		TRY(carry_send(d, d->queue, NULL, block, buffer, offset + at, load.bytes));
	}
	return SCREE_OK;
}

scree_status carry_down(OpenCl* d, cl_mem buffer, size_t offset, void* bytes, size_t count)
{
	TRY(carry_open(d));
	int parts = (int)((count + CARRY_PART - 1) / CARRY_PART);
	for (int k = 0; k <= parts; ++k)
	{
		size_t at = CARRY_PART * (size_t)k;
		if (k < parts)
		{
			TRY(carry_settle(d, k & 1));
			TRY(carry_fetch(d, d->queue, NULL, k & 1, buffer, offset + at, smaller(CARRY_PART, count - at)));
		}
		if (k == 0)
			continue;
		size_t before = at - CARRY_PART;
		TRY(carry_settle(d, (k - 1) & 1));
		carry_copy(d, &(Load){(char*)bytes + before, carry_block(d, (k - 1) & 1), smaller(CARRY_PART, count - before)},
		           1);
	}
	return SCREE_OK;
}

void carry_close(OpenCl* d)
{
	for (int block = 0; block < CARRY_BLOCKS; ++block)
		if (d->carry.events[block])
			opencl.ReleaseEvent(d->carry.events[block]);
	threads_close(d->carry.threads);
	pinned_close(d, &d->carry.pinned);
}
