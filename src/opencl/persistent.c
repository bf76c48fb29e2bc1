// SPDX-License-Identifier: MIT
// persistent.c -- launches many runs at once (persistent.cl), where the device can.
#include "opencl/persistent.h"
#include "opencl/buffer.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "platform/error.h"
#include <stdlib.h>
#include <string.h>

// Beyond this many items in a run, launches are faster: the time is memory's then, and a launch fills the device better
// than the few groups that can meet. Measured on an H200, pyramids, solve of 88 runs, persistent and launched: 10k bodies
// 0.29 and 0.51 ms, 100k 0.40 and 0.49, 300k 1.10 and 0.86. What comes before the solve is short: 1M mixed bodies in
// motion, 3M contacts: 1.37 and 1.14 ms.
#define PERSISTENT_SOLVE 150000
#define PERSISTENT_ITEMS 1000000

// Bounds of the wait at a meeting, in looks at the counter of half a microsecond or so: 2 s, and 30 ms for the probe. A
// launch of the solver must never reach the bound, the probe may: then launches are used.
#define SPINS       (1 << 22)
#define PROBE_SPINS (1 << 16)
#define PROBE_RUNS  64

// own arguments of the kernel
enum
{
	ARGUMENT_LIST = ARGUMENT_FIRST,
	ARGUMENT_COUNT,
	ARGUMENT_TABLE,
	ARGUMENT_PROBES,
	ARGUMENT_SPINS
};

// Launches runs. A settled world's are the same in every step, and are sent once.
static scree_status launch_list(OpenCl* d, const Run* runs, cl_int count, int groups, cl_int spins)
{
	cl_kernel kernel = d->persistent.kernel.kernel;
	size_t bytes = (size_t)count * sizeof(Run);
	if (count != d->persistent.listed_count || memcmp(d->persistent.listed, runs, bytes) != 0)
	{
		TRY(upload(d, d->persistent.list, PERSISTENT_HEADER * sizeof(cl_int), runs, bytes));
		memcpy(d->persistent.listed, runs, bytes);
		d->persistent.listed_count = count;
	}
	TRY(kernel_step(d, &d->persistent.kernel));
	TRY(CALL(SetKernelArg, kernel, ARGUMENT_COUNT, sizeof count, &count));
	TRY(CALL(SetKernelArg, kernel, ARGUMENT_SPINS, sizeof spins, &spins));
	return launch(d, kernel, (size_t)groups * d->persistent.kernel.group, d->persistent.kernel.group);
}

// Whether the groups really meet, and see what the others wrote before.
static scree_status probe(OpenCl* d, bool* meets)
{
	Run runs[PROBE_RUNS];
	for (int k = 0; k < PROBE_RUNS; ++k)
		runs[k] = (Run){PERSISTENT_PROBE, 0, d->persistent.groups * (int)d->persistent.kernel.group, NO_COUNT, k};
	TRY(launch_list(d, runs, PROBE_RUNS, d->persistent.groups, PROBE_SPINS));
	TRY(finish(d));

	cl_int fault;
	size_t at = pool_offset(d, POOL_counters) + offsetof(Counters, fault);
	cl_mem counters = d->buffers[ONE];
	TRY(CALL(EnqueueReadBuffer, d->queue, counters, CL_TRUE, at, sizeof fault, &fault, 0, NULL, NULL));
	*meets = fault == 0;
	if (*meets)
		return SCREE_OK;
	log_sentence(SCREE_LOG_INFO, "%s: %s; each run is a launch.", d->device.about.name,
	             fault == FAULT_TIMEOUT ? "work-groups do not run together" : "work-groups see stale memory");
	fault = 0;
	return upload(d, counters, at, &fault, sizeof fault);
}

bool persistent_wanted(OpenCl* d)
{
	const char* forced = getenv("SCREE_PERSISTENT");
	d->persistent.any_size = forced && *forced && strcmp(forced, "0") != 0;
	return forced && *forced ? d->persistent.any_size : !(d->device.type & CL_DEVICE_TYPE_CPU);
}

scree_status persistent_open(OpenCl* d)
{
	bool cpu = d->device.type & CL_DEVICE_TYPE_CPU;
	// groups that are on the device together for certain: those that could be one group, on each compute unit. A CPU
	// runs groups to their end one after the other: only one meets, which serves tests.
	size_t most = 0;
	TRY(CALL(GetKernelWorkGroupInfo, d->persistent.kernel.kernel, d->device.id, CL_KERNEL_WORK_GROUP_SIZE, sizeof most,
	         &most, NULL));
	if (d->persistent.kernel.group != PERSISTENT_GROUP)
		return SCREE_OK;
	d->persistent.groups = cpu ? 1 : d->device.about.units * (int)(most / d->persistent.kernel.group);
	d->persistent.listed = scree_allocate(PERSISTENT_GROUP * sizeof(Run));
	if (!d->persistent.listed)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for the runs of an OpenCL device.");
	TRY(buffer_create(d, PERSISTENT_HEADER * sizeof(cl_int) + PERSISTENT_GROUP * sizeof(Run), &d->persistent.list));
	TRY(buffer_create(d, 2 * (size_t)d->persistent.groups * d->persistent.kernel.group * sizeof(cl_int),
	                  &d->persistent.probes));
	TRY(CALL(SetKernelArg, d->persistent.kernel.kernel, ARGUMENT_LIST, sizeof d->persistent.list, &d->persistent.list));
	TRY(CALL(SetKernelArg, d->persistent.kernel.kernel, ARGUMENT_TABLE, sizeof d->primitives.table,
	         &d->primitives.table));
	TRY(CALL(SetKernelArg, d->persistent.kernel.kernel, ARGUMENT_PROBES, sizeof d->persistent.probes,
	         &d->persistent.probes));

	d->constants.version = 1; // the probe needs a step, whatever it holds
	bool meets;
	TRY(probe(d, &meets));
	if (!meets)
		d->persistent.groups = 0;
	return SCREE_OK;
}

void persistent_close(OpenCl* d)
{
	if (d->persistent.kernel.kernel)
		opencl.ReleaseKernel(d->persistent.kernel.kernel);
	if (d->persistent.list)
		opencl.ReleaseMemObject(d->persistent.list);
	if (d->persistent.probes)
		opencl.ReleaseMemObject(d->persistent.probes);
	scree_release(d->persistent.listed);
}

static int items(const Run* run) { return run->end - run->begin; }

static bool takes_group(const Run* run) { return run->stage < STAGE_COUNT && stage_widths[run->stage] == WIDTH_GROUP; }

// how many items a run will have, if counters are what they were
static int likely_items(const OpenCl* d, const Run* run)
{
	int end = run->end;
	if (run->count >= 0)
	{
		int bound = ((const int*)&d->persistent.last)[run->count];
		end = bound < end ? bound : end;
	}
	return end - run->begin;
}

// a primitive counts to the box of the run before it
static Box box_of(const Run* run, Box before) { return run->stage < STAGE_COUNT ? stage_boxes[run->stage] : before; }

int persistent_length(const OpenCl* d, const Run* runs, int count)
{
	if (d->persistent.groups == 0)
		return 0;
	Box box = box_of(runs, d->timing.box);
	int k = 0;
	for (; k < count && k < PERSISTENT_GROUP; ++k)
	{
		Box own = box_of(&runs[k], box);
		bool long_one = likely_items(d, &runs[k]) > (own == BOX_solve ? PERSISTENT_SOLVE : PERSISTENT_ITEMS);
		if ((long_one && !d->persistent.any_size) || (d->timing.laps && own != box) || takes_group(&runs[k]))
			break;
	}
	return k > 1 ? k : 0;
}

scree_status persistent_run(OpenCl* d, const Run* runs, int count)
{
	int largest = 1, group = (int)d->persistent.kernel.group;
	for (int k = 0; k < count; ++k)
		largest = items(&runs[k]) > largest ? items(&runs[k]) : largest;
	int groups = (largest - 1) / group + 1;
	d->timing.box = box_of(runs, d->timing.box);
	return launch_list(d, runs, count, groups < d->persistent.groups ? groups : d->persistent.groups, SPINS);
}
