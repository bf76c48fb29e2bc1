// SPDX-License-Identifier: MIT
// execute.c -- executes lists of runs: a launch per run, or one launch for many runs (persistent.c).
#include "opencl/execute.h"
#include "opencl/launch.h"
#include "opencl/persistent.h"
#include "opencl/primitives.h"
#include "platform/error.h"

static scree_status one_run(OpenCl* d, const Run* run)
{
	if (run->begin >= run->end)
		return SCREE_OK;
	return run->kernel_id < KERNEL_COUNT ? kernel_run(d, run) : primitive_run(d, run);
}

scree_status opencl_run(Backend* b, const Step* step, const Run* runs, int count)
{
	OpenCl* d = b->state;
	step_set(d, step);
	// commands may change masses, so tiles may be wrong; after a new order of the leaves, new tiles are faster
	for (int i = 0; i < count; ++i)
	{
		d->tiles.stale |= runs[i].kernel_id == KERNEL_command || runs[i].kernel_id == KERNEL_tree_order ||
		                  runs[i].kernel_id == KERNEL_bay_count;
		d->tiles.pushed |= runs[i].kernel_id == KERNEL_field_body;
	}
	for (int i = 0; i < count;)
	{
		int length = persistent_length(d, runs + i, count - i);
		TRY(length ? persistent_run(d, runs + i, length) : one_run(d, runs + i));
		i += length ? length : 1;
	}
	return CALL(d->failure, Flush, d->queue);
}
