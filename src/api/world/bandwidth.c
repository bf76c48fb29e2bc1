// SPDX-License-Identifier: MIT
// bandwidth.c -- returns the memory traffic of a step, and measures the bandwidth of copies on the device.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/world.h"

#define MOST_BYTES  ((size_t)256 << 20) // bytes of a block; halved, down to LEAST_BYTES, until memory has space for two
#define LEAST_BYTES ((size_t)1 << 20)
#define TRIES       4     // number of tries; the fastest counts
#define COPIES      8     // copies per try; many, so that the time to start and end a try has little effect
#define ENOUGH      500.0 // ms: total time of the tries after which no further try begins

scree_status api_world_get_traffic_sized(scree_world* world, scree_traffic* traffic, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_traffic";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "traffic", traffic));
	write_result(traffic, size, &world->pipeline.traffic, sizeof world->pipeline.traffic);
	return SCREE_OK;
}

static scree_status time_copies(Backend* b, size_t bytes, double* bandwidth)
{
	TRY(b->f->copy(b, 1));
	double spent = 0;
	for (int k = 0; k < TRIES && spent < ENOUGH; ++k)
	{
		double begin = processor_milliseconds();
		TRY(b->f->copy(b, COPIES));
		double time = processor_milliseconds() - begin;
		double found = time > 0 ? 1e3 * 2.0 * COPIES * (double)bytes / time : 0;
		*bandwidth = found > *bandwidth ? found : *bandwidth;
		spent += time;
	}
	return SCREE_OK;
}

scree_status api_world_measure_bandwidth(scree_world* world, double* bandwidth)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_measure_bandwidth";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "bandwidth", bandwidth));
	Backend* b = world->backend;
	size_t bytes = MOST_BYTES;
	scree_status status = b->f->copy_reserve(b, bytes);
	while (status == SCREE_ERROR_OUT_OF_MEMORY && bytes > LEAST_BYTES)
	{
		bytes /= 2;
		status = b->f->copy_reserve(b, bytes);
	}
	double found = 0;
	if (status == SCREE_OK)
		status = time_copies(b, bytes, &found);
	b->f->copy_release(b);
	if (status == SCREE_OK)
		*bandwidth = found;
	return world_note(world, status);
}
