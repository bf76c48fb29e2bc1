// SPDX-License-Identifier: MIT
// carry.c -- large arrays to and from a GPU: by several threads through pinned memory.
//
// A driver copies an array of the user through pinned memory of its own, with one thread: 7 GB/s on the host of an H200, an eighth of
// what the bus can do. Here several threads copy one half of a pinned block while the device transfers the other one.
#include "opencl/carry.h"
#include "opencl/buffer.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <string.h>

#define CARRY_HALF    ((size_t)4 << 20)
#define CARRY_LEAST   CARRY_HALF
#define CARRY_THREADS 6

typedef struct // a copy in the host's memory
{
	char* to;
	const char* from;
	size_t bytes;
} Load;

static void copy_share(void* context, int worker, int workers)
{
	const Load* load = context;
	size_t share = (load->bytes / (size_t)workers + 63) / 64 * 64, begin = share * (size_t)worker;
	if (begin >= load->bytes)
		return;
	size_t left = load->bytes - begin;
	memcpy(load->to + begin, load->from + begin, left < share ? left : share);
}

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

bool carry_wanted(const OpenCl* d, size_t count)
{
	return count > CARRY_LEAST && !(d->device.type & CL_DEVICE_TYPE_CPU);
}

static scree_status open_carry(OpenCl* d)
{
	Carry* c = &d->carry;
	int cores = processor_cores();
	if (!c->pinned.memory)
		TRY(pinned_open(d, 2 * CARRY_HALF, &c->pinned));
	if (!c->threads)
		c->threads = threads_open(cores < CARRY_THREADS ? cores : CARRY_THREADS);
	return c->threads ? SCREE_OK : SCREE_ERROR_OUT_OF_MEMORY;
}

// Waits until the device has done with a half.
static scree_status settle(OpenCl* d, int half)
{
	cl_event* event = &d->carry.events[half];
	if (!*event)
		return SCREE_OK;
	scree_status status = CALL(WaitForEvents, 1, event);
	opencl.ReleaseEvent(*event);
	*event = NULL;
	return status;
}

static unsigned char* half_of(const OpenCl* d, int half) { return d->carry.pinned.memory + CARRY_HALF * (size_t)half; }

scree_status carry_up(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count)
{
	TRY(open_carry(d));
	int half = 0;
	for (size_t at = 0; at < count; at += CARRY_HALF, half ^= 1)
	{
		size_t part = smaller(CARRY_HALF, count - at);
		TRY(settle(d, half));
		threads_run(d->carry.threads, copy_share, &(Load){(char*)half_of(d, half), (const char*)bytes + at, part});
		TRY(CALL(EnqueueWriteBuffer, d->queue, buffer, CL_FALSE, offset + at, part, half_of(d, half), 0, NULL,
		         &d->carry.events[half]));
		TRY(CALL(Flush, d->queue));
	}
	return SCREE_OK;
}

scree_status carry_down(OpenCl* d, cl_mem buffer, size_t offset, void* bytes, size_t count)
{
	TRY(open_carry(d));
	int parts = (int)((count + CARRY_HALF - 1) / CARRY_HALF);
	for (int k = 0; k <= parts; ++k)
	{
		size_t at = CARRY_HALF * (size_t)k;
		if (k < parts)
		{
			TRY(settle(d, k & 1));
			TRY(CALL(EnqueueReadBuffer, d->queue, buffer, CL_FALSE, offset + at, smaller(CARRY_HALF, count - at),
			         half_of(d, k & 1), 0, NULL, &d->carry.events[k & 1]));
			TRY(CALL(Flush, d->queue));
		}
		if (k == 0)
			continue;
		size_t before = at - CARRY_HALF;
		TRY(settle(d, (k - 1) & 1));
		Load load = {(char*)bytes + before, (char*)half_of(d, (k - 1) & 1), smaller(CARRY_HALF, count - before)};
		threads_run(d->carry.threads, copy_share, &load);
	}
	return SCREE_OK;
}

void carry_close(OpenCl* d)
{
	for (int half = 0; half < 2; ++half)
		if (d->carry.events[half])
			opencl.ReleaseEvent(d->carry.events[half]);
	threads_close(d->carry.threads);
	pinned_close(d, &d->carry.pinned);
}
