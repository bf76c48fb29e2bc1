// SPDX-License-Identifier: MIT
// primitives.c -- launches sort and scan (primitives.cl).
#include "opencl/primitives.h"
#include "opencl/buffer.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "platform/error.h"

// Returns the number of work-groups for `items` items: one per `grain` items, limited to `most`.
static size_t groups_for(int items, int grain, int most)
{
	int groups = (items - 1) / grain + 1;
	return (size_t)(groups < most ? groups : most);
}

static scree_status set_buffers(OpenCl* d, cl_kernel kernel, const cl_mem* buffers, cl_uint count)
{
	for (cl_uint i = 0; i < count; ++i)
		TRY(CALL(d->failure, SetKernelArg, kernel, i, sizeof *buffers, &buffers[i]));
	return SCREE_OK;
}

scree_status primitives_bind(OpenCl* d)
{
	cl_ulong scan = pool_offset(d, POOL_scan);
	cl_kernel scans[] = {d->primitives.scan_sum, d->primitives.scan_place};
	for (int i = 0; i < 2; ++i)
	{
		TRY(set_buffers(d, scans[i], (cl_mem[]){d->buffers[PER_CONTACT], d->buffers[PER_ONE], d->primitives.table}, 3));
		TRY(CALL(d->failure, SetKernelArg, scans[i], 4, sizeof scan, &scan));
	}
	cl_ulong from = pool_offset(d, POOL_key_other), to = pool_offset(d, POOL_key);
	TRY(set_buffers(d, d->primitives.sort_count,
	                (cl_mem[]){d->buffers[PER_KEY], d->buffers[PER_ONE], d->primitives.table}, 3));
	TRY(set_buffers(d, d->primitives.sort_place,
	                (cl_mem[]){d->buffers[PER_KEY], d->buffers[PER_ONE], d->primitives.table}, 3));
	TRY(set_buffers(d, d->primitives.sort_return, (cl_mem[]){d->buffers[PER_KEY], d->buffers[PER_ONE]}, 2));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_return, 3, sizeof from, &from));
	return CALL(d->failure, SetKernelArg, d->primitives.sort_return, 4, sizeof to, &to);
}

scree_status primitives_open(OpenCl* d)
{
	const struct
	{
		const char* name;
		cl_kernel* kernel;
	} kernels[] = {
	    {"sort_count", &d->primitives.sort_count},   {"sort_place", &d->primitives.sort_place},
	    {"sort_return", &d->primitives.sort_return}, {"scan_sum", &d->primitives.scan_sum},
	    {"scan_place", &d->primitives.scan_place},
	};
	for (size_t i = 0; i < sizeof kernels / sizeof *kernels; ++i)
		TRY(kernel_create_fixed(d, kernels[i].name, PRIMITIVE_GROUP, kernels[i].kernel));
	return buffer_create(d, (size_t)SORT_BLOCKS * SORT_DIGITS * sizeof(cl_uint), &d->primitives.table);
}

void primitives_close(OpenCl* d)
{
	cl_kernel kernels[] = {d->primitives.sort_count, d->primitives.sort_place, d->primitives.sort_return,
	                       d->primitives.scan_sum, d->primitives.scan_place};
	for (size_t i = 0; i < sizeof kernels / sizeof *kernels; ++i)
		RELEASE(d->failure, Kernel, kernels[i]);
	RELEASE(d->failure, MemObject, d->primitives.table);
}

// Launches a pass of the sort by `bits` bits from `shift` on. from, to: byte offsets of source and destination.
static scree_status sort_pass(OpenCl* d, const Run* run, cl_ulong from, cl_ulong to, cl_int shift, int bits)
{
	cl_uint mask = (1u << bits) - 1;
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_count, 3, sizeof *run, run));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_count, 4, sizeof from, &from));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_count, 5, sizeof shift, &shift));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_count, 6, sizeof mask, &mask));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_place, 3, sizeof *run, run));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_place, 4, sizeof from, &from));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_place, 5, sizeof to, &to));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_place, 6, sizeof shift, &shift));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_place, 7, sizeof mask, &mask));
	size_t items = PRIMITIVE_GROUP * groups_for(run->end, SORT_GRAIN, SORT_BLOCKS);
	TRY(launch(d, d->primitives.sort_count, items, PRIMITIVE_GROUP));
	return launch(d, d->primitives.sort_place, items, PRIMITIVE_GROUP);
}

static scree_status sort_run(OpenCl* d, const Run* run)
{
	int first = RUN_LOW(run->argument), end = RUN_HIGH(run->argument);
	int passes = (end - first + SORT_DIGIT_BITS - 1) / SORT_DIGIT_BITS;
	cl_ulong from = pool_offset(d, POOL_key), to = pool_offset(d, POOL_key_other);
	for (int pass = 0; pass < passes; ++pass)
	{
		int shift = first + pass * SORT_DIGIT_BITS;
		TRY(sort_pass(d, run, from, to, shift, end - shift < SORT_DIGIT_BITS ? end - shift : SORT_DIGIT_BITS));
		cl_ulong swapped = from;
		from = to;
		to = swapped;
	}
	if (passes % 2 == 0)
		return SCREE_OK;

	// after an odd number of passes the keys are in key_other; a copy takes less time than another pass
	TRY(CALL(d->failure, SetKernelArg, d->primitives.sort_return, 2, sizeof *run, run));
	return launch(d, d->primitives.sort_return,
	              PRIMITIVE_GROUP * groups_for(run->end, PRIMITIVE_GROUP, 4 * SORT_BLOCKS), PRIMITIVE_GROUP);
}

static scree_status scan_run(OpenCl* d, const Run* run)
{
	size_t items = PRIMITIVE_GROUP * groups_for(run->end, SCAN_GRAIN, SCAN_BLOCKS);
	TRY(CALL(d->failure, SetKernelArg, d->primitives.scan_sum, 3, sizeof *run, run));
	TRY(CALL(d->failure, SetKernelArg, d->primitives.scan_place, 3, sizeof *run, run));
	TRY(launch(d, d->primitives.scan_sum, items, PRIMITIVE_GROUP));
	return launch(d, d->primitives.scan_place, items, PRIMITIVE_GROUP);
}

scree_status primitive_run(OpenCl* d, const Run* run)
{
	return run->kernel_id == PRIMITIVE_SORT ? sort_run(d, run) : scan_run(d, run);
}
