// SPDX-License-Identifier: MIT
// persistent.c -- executes many runs in one launch (persistent.cl), on devices that support it.
#include "opencl/persistent.h"
#include "opencl/buffer.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "opencl/readback.h"
#include "platform/error.h"
#include <string.h>

// Maximum number of items of a run, in a solve and in other stages. Longer runs are faster as launches: bandwidth
// limits them, and a launch has a higher occupancy than resident work-groups. Times on an H200, ms, persistent kernel
// and launches. Solve of scene pyramids, 88 runs: 0.29 and 0.51 for 10k bodies; 0.40 and 0.49 for 100k; 1.10 and 0.86
// for 300k. Short runs before the solve, 1M mixed bodies in motion with 3M contacts: 1.37 and 1.14.
#define PERSISTENT_SOLVE 150000
#define PERSISTENT_ITEMS 1000000

#define SPINS       (1 << 22) // limit of a spin-wait, in reads of about 0.5 us: 2 s, longer than any step
#define PROBE_SPINS (1 << 16) // limit of a spin-wait of the probe, which may fail: 30 ms
#define PROBE_RUNS  64

// kernel arguments that follow the step
enum
{
	ARGUMENT_LIST = ARGUMENT_FIRST,
	ARGUMENT_COUNT,
	ARGUMENT_TABLE,
	ARGUMENT_PROBES,
	ARGUMENT_SPINS
};

// Launches the kernel with a list of runs; uploads the list only if it changed, which is rare in a settled world.
static scree_status launch_list(OpenCl* d, const Run* runs, cl_int count, int groups, cl_int spins)
{
	Persistent* own = &d->persistent;
	cl_kernel kernel = own->kernel.kernel;
	size_t bytes = (size_t)count * sizeof(Run);
	if (count != own->contact_report_count || memcmp(own->listed, runs, bytes) != 0)
	{
		TRY(upload(d, own->list, PERSISTENT_HEADER * sizeof(cl_int), runs, bytes));
		memcpy(own->listed, runs, bytes);
		own->contact_report_count = count;
	}
	TRY(kernel_step(d, &own->kernel));
	TRY(CALL(d->failure, SetKernelArg, kernel, ARGUMENT_COUNT, sizeof count, &count));
	TRY(CALL(d->failure, SetKernelArg, kernel, ARGUMENT_SPINS, sizeof spins, &spins));
	return launch(d, kernel, (size_t)groups * own->kernel.group, own->kernel.group);
}

// Tests whether all work-groups are resident at once and read values that others wrote before a barrier. Sets *works.
static scree_status probe(OpenCl* d, bool* works)
{
	Run runs[PROBE_RUNS];
	for (int k = 0; k < PROBE_RUNS; ++k)
		runs[k] = (Run){PERSISTENT_PROBE, 0, d->persistent.groups * (int)d->persistent.kernel.group, NO_COUNT, k};
	TRY(launch_list(d, runs, PROBE_RUNS, d->persistent.groups, PROBE_SPINS));
	TRY(finish(d));

	cl_int fault;
	size_t at = pool_offset(d, POOL_counters) + offsetof(Counters, fault);
	cl_mem counters = d->buffers[PER_ONE];
	TRY(read_now(d, counters, at, sizeof fault, &fault));
	*works = fault == 0;
	if (*works)
		return SCREE_OK;
	log_sentence(SCREE_LOG_INFO, "%s: %s; each run is a launch.", d->device.about.name,
	             fault == FAULT_TIMEOUT ? "work-groups are not resident at once" : "work-groups see stale memory");
	fault = 0;
	return upload(d, counters, at, &fault, sizeof fault);
}

scree_status persistent_open(OpenCl* d)
{
	Persistent* own = &d->persistent;
	// lower bound of resident work-groups: a compute unit has room for at least one group of the largest size
	size_t most;
	TRY(kernel_group_most(d, own->kernel.kernel, &most));
	if (own->kernel.group != PERSISTENT_GROUP)
	{
		log_sentence(SCREE_LOG_INFO,
		             "%s: a work-group of the persistent kernel holds %zu work-items; each run is a launch.",
		             d->device.about.name, own->kernel.group);
		return SCREE_OK;
	}
	own->groups = d->device.about.compute_units * (int)(most / own->kernel.group);
	own->listed = scree_allocate(PERSISTENT_GROUP * sizeof(Run));
	if (!own->listed)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "There is no memory for the runs of an OpenCL device.");
	TRY(buffer_create(d, PERSISTENT_HEADER * sizeof(cl_int) + PERSISTENT_GROUP * sizeof(Run), &own->list));
	TRY(buffer_create(d, 2 * (size_t)own->groups * own->kernel.group * sizeof(cl_int), &own->probes));
	TRY(CALL(d->failure, SetKernelArg, own->kernel.kernel, ARGUMENT_LIST, sizeof own->list, &own->list));
	TRY(CALL(d->failure, SetKernelArg, own->kernel.kernel, ARGUMENT_TABLE, sizeof d->primitives.table,
	         &d->primitives.table));
	TRY(CALL(d->failure, SetKernelArg, own->kernel.kernel, ARGUMENT_PROBES, sizeof own->probes, &own->probes));

	d->constants.version = 1; // kernels need a step as argument; its values do not matter for the probe
	bool works;
	TRY(probe(d, &works));
	if (!works)
		own->groups = 0;
	return SCREE_OK;
}

void persistent_close(OpenCl* d)
{
	Persistent* own = &d->persistent;
	RELEASE(d->failure, Kernel, own->kernel.kernel);
	RELEASE(d->failure, MemObject, own->list);
	RELEASE(d->failure, MemObject, own->probes);
	scree_release(own->listed);
}

static int item_count(const Run* run) { return run->end - run->begin; }

static bool is_left_out(const Run* run)
{
	return run->kernel_id < KERNEL_COUNT && kernel_widths[run->kernel_id] >= WIDTH_ALONE;
}

// Returns the number of items of a run, estimated with the counters that the host has last read.
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

// Returns the stage of a run: for a primitive, the stage of the run before it.
static Stage stage_of(const Run* run, Stage before)
{
	return run->kernel_id < KERNEL_COUNT ? kernel_stages[run->kernel_id] : before;
}

int persistent_length(const OpenCl* d, const Run* runs, int count)
{
	if (d->persistent.groups == 0)
		return 0;
	Stage stage = stage_of(runs, d->timing.stage);
	int k = 0;
	for (; k < count && k < PERSISTENT_GROUP; ++k)
	{
		Stage own = stage_of(&runs[k], stage);
		bool long_one = likely_items(d, &runs[k]) > (own == STAGE_solve ? PERSISTENT_SOLVE : PERSISTENT_ITEMS);
		if ((long_one && !d->persistent.any_size) || (d->timing.laps && own != stage) || is_left_out(&runs[k]))
			break;
	}
	return k > 1 ? k : 0;
}

scree_status persistent_run(OpenCl* d, const Run* runs, int count)
{
	int largest = 1, group = (int)d->persistent.kernel.group;
	for (int k = 0; k < count; ++k)
		largest = item_count(&runs[k]) > largest ? item_count(&runs[k]) : largest;
	int groups = (largest - 1) / group + 1;
	d->timing.stage = stage_of(runs, d->timing.stage);
	return launch_list(d, runs, count, groups < d->persistent.groups ? groups : d->persistent.groups, SPINS);
}
