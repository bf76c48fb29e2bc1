// SPDX-License-Identifier: MIT
// round_trip_parts.c -- executes a round trip on a GPU in parts that overlap: sends items, runs the kernel, fetches results.
//
// While the kernel works on a part, the items of the next part are sent and the results of the previous part are
// fetched: a bus transfers both ways at once. Each direction and the kernel have a queue; events order their commands.
#include "opencl/round_trip_parts.h"
#include "backend/round_trip.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "opencl/transfer.h"
#include "platform/error.h"

#define DEPTH (TRANSFER_BLOCKS / 2) // maximum number of parts in flight; a part has blocks for items and for results

// Number of parts of a round trip, unless the size of a block requires another number. With several parts, transfers and
// kernels overlap, but kernels take longer: for a million rays 1.9 ms in one part, 2.3 in four, 3.0 in eight (H200).
#define PARTS 4

typedef struct
{
	OpenCl* d;
	const RoundTrip* trip;
	size_t item, answer; // bytes of an item, and of its result
	int part, parts;     // items per part; number of parts
} Way;

typedef struct
{
	const RoundTrip* trip;
	bool bad[MAX_WORKERS];
} RoundTripCheck;

static void check_share(void* context, int block, int blocks)
{
	RoundTripCheck* checked = context;
	const RoundTrip* x = checked->trip;
	int share = x->run.end / blocks + 1, begin = share * block,
	    end = begin + share < x->run.end ? begin + share : x->run.end;
	checked->bad[block] = begin < end && x->check(x->context, begin, end) != SCREE_OK;
}

// Checks all items, in several threads. The error message is that of the first bad item.
static scree_status check(OpenCl* d, const RoundTrip* x)
{
	RoundTripCheck checked = {.trip = x};
	if (!x->check)
		return SCREE_OK;
	threads_run_once(d->transfer.threads, check_share, &checked);
	for (int block = 0; block < MAX_WORKERS; ++block)
		if (checked.bad[block])
			return x->check(x->context, 0, x->run.end);
	return SCREE_OK;
}

static int clamp(int x, int low, int high) { return x < low ? low : x > high ? high : x; }

static int first_of(const Way* way, int k) { return way->part * k; }

static int count_of(const Way* way, int k)
{
	int left = way->trip->run.end - first_of(way, k);
	return left < way->part ? left : way->part;
}

static int up_block(int k) { return k % DEPTH; }

static int down_block(int k) { return DEPTH + k % DEPTH; }

// Copies the items of part k to a block if k < parts, and the results of part `back` to the user if back >= 0.
static void copy(const Way* way, int k, int back)
{
	const RoundTrip* x = way->trip;
	Load loads[2];
	int count = 0;
	if (k < way->parts)
		loads[count++] =
		    (Load){transfer_block(way->d, up_block(k)), (const char*)x->items + way->item * (size_t)first_of(way, k),
		           way->item * (size_t)count_of(way, k)};
	if (back >= 0)
		loads[count++] = (Load){(char*)x->answers + way->answer * (size_t)first_of(way, back),
		                        transfer_block(way->d, down_block(back)), way->answer * (size_t)count_of(way, back)};
	if (count > 0)
		transfer_copy(way->d, loads, count);
}

// Enqueues all commands of part k. begin: event after which the device may overwrite the pool of the items.
static scree_status enqueue(const Way* way, int k, cl_event begin)
{
	OpenCl* d = way->d;
	const RoundTrip* x = way->trip;
	int first = first_of(way, k), count = count_of(way, k);
	Run run = x->run;
	run.begin = first;
	run.end = first + count;
	TRY(transfer_send(d, d->transfer.up, begin, up_block(k), pool_buffer(d, x->asked),
	                  pool_offset(d, x->asked) + way->item * (size_t)first, way->item * (size_t)count));
	TRY(CALL(d->failure, EnqueueBarrierWithWaitList, d->queue, 1, &d->transfer.events[up_block(k)], NULL));
	TRY(kernel_run(d, &run));
	cl_event done;
	TRY(CALL(d->failure, EnqueueBarrierWithWaitList, d->queue, 0, NULL, &done));
	scree_status status = CALL(d->failure, Flush, d->queue);
	if (status == SCREE_OK)
		status = transfer_fetch(d, d->transfer.down, done, down_block(k), pool_buffer(d, x->answered),
		                        pool_offset(d, x->answered) + way->answer * (size_t)first, way->answer * (size_t)count);
	RELEASE(d->failure, Event, done);
	return status;
}

static scree_status go(const Way* way)
{
	OpenCl* d = way->d;
	cl_event begin;
	TRY(CALL(d->failure, EnqueueBarrierWithWaitList, d->queue, 0, NULL, &begin));
	scree_status status = CALL(d->failure, Flush, d->queue);
	// iteration k sends part k, and copies the results of part k - DEPTH
	for (int k = 0; k < way->parts + DEPTH && status == SCREE_OK; ++k)
	{
		int back = k - DEPTH;
		if (back == 0)
			status = check(d, way->trip);
		if (back >= 0 && back < way->parts && status == SCREE_OK)
			status = transfer_settle(d, down_block(back)); // the results are there, so the kernel has read the items
		if (status != SCREE_OK)
			break;
		if (k < way->parts)
			status = transfer_settle(d, up_block(k));
		if (status != SCREE_OK)
			break;
		copy(way, k, back < way->parts ? back : -1);
		if (k < way->parts)
			status = enqueue(way, k, begin);
	}
	RELEASE(d->failure, Event, begin);
	return status;
}

static scree_status queue_open(OpenCl* d, cl_command_queue* queue)
{
	cl_int error = CL_SUCCESS;
	if (!*queue)
		CREATE(d->failure, *queue, error, CommandQueue, d->context, d->device.id, 0);
	return context_check(d->failure, "clCreateCommandQueue", error);
}

scree_status opencl_round_trip(Backend* b, const Step* step, const RoundTrip* trip)
{
	OpenCl* d = b->state;
	Way way = {d, trip, pool_info[trip->asked].bytes, pool_info[trip->answered].bytes, 0, 0};
	size_t larger = way.item > way.answer ? way.item : way.answer;
	int most = (int)(TRANSFER_BLOCK / larger), count = trip->run.end;
	if (count <= most / 2)
		return round_trip_whole(b, step, trip);
	way.part = clamp(count / PARTS + 1, most / 2, most);
	way.parts = (count + way.part - 1) / way.part;
	TRY(transfer_open(d));
	TRY(queue_open(d, &d->transfer.up));
	TRY(queue_open(d, &d->transfer.down));
	step_set(d, step);
	scree_status status = go(&way);
	if (status == SCREE_OK)
	{
		d->staging.used = 0; // the uploads ended before the results arrived
		return SCREE_OK;
	}
	// all transfers end before the blocks are used again, unless the context has failed
	const Sentence kept = sentence_keep();
	cl_command_queue queues[] = {d->transfer.up, d->queue, d->transfer.down};
	for (int k = 0; k < 3 && !context_failed(d->failure); ++k)
		queue_finish(d, queues[k]);
	sentence_restore(&kept);
	return status;
}

void round_trip_close(OpenCl* d)
{
	RELEASE(d->failure, CommandQueue, d->transfer.up);
	RELEASE(d->failure, CommandQueue, d->transfer.down);
}
