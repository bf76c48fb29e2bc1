// SPDX-License-Identifier: MIT
// primitives.c -- launches sort and scan (primitives.cl).
#include "error.h"
#include "opencl/opencl.h"

// most groups of a part each that so many items can use
static size_t groups_for(int items, int grain, int most)
{
	int groups = (items - 1) / grain + 1;
	return (size_t)(groups < most ? groups : most);
}

static scree_status set_arguments(cl_kernel kernel, const cl_mem* buffers, cl_uint count)
{
	for (cl_uint i = 0; i < count; ++i)
		TRY(CALL(SetKernelArg, kernel, i, sizeof *buffers, &buffers[i]));
	return SCREE_OK;
}

scree_status primitives_bind(OpenCl* d)
{
	cl_mem counters = d->pools[POOL_counters], scan = d->pools[POOL_scan];
	TRY(set_arguments(d->scan_sum, (cl_mem[]){scan, counters, d->table}, 3));
	TRY(set_arguments(d->scan_place, (cl_mem[]){scan, counters, d->table}, 3));
	return set_arguments(d->sort_return, (cl_mem[]){d->pools[POOL_key], d->pools[POOL_key_other], counters}, 3);
}

scree_status primitives_open(OpenCl* d)
{
	const struct
	{
		const char* name;
		cl_kernel* kernel;
	} kernels[] = {
	    {"sort_count", &d->sort_count}, {"sort_place", &d->sort_place}, {"sort_return", &d->sort_return},
	    {"scan_sum", &d->scan_sum},     {"scan_place", &d->scan_place},
	};
	for (size_t i = 0; i < sizeof kernels / sizeof *kernels; ++i)
	{
		cl_int error;
		*kernels[i].kernel = opencl.CreateKernel(d->program, kernels[i].name, &error);
		if (error)
			return fail(SCREE_DEVICE_FAILED, "clCreateKernel of %s: %s (%d)", kernels[i].name, opencl_error_name(error),
			            (int)error);
	}
	TRY(buffer_create(d, (size_t)SORT_BLOCKS * SORT_DIGITS * sizeof(cl_uint), &d->table));
	return primitives_bind(d);
}

void primitives_close(OpenCl* d)
{
	cl_kernel kernels[] = {d->sort_count, d->sort_place, d->sort_return, d->scan_sum, d->scan_place};
	for (size_t i = 0; i < sizeof kernels / sizeof *kernels; ++i)
		if (kernels[i])
			opencl.ReleaseKernel(kernels[i]);
	if (d->table)
		opencl.ReleaseMemObject(d->table);
}

// One pass: orders the keys of one buffer by bits shift to shift + bits - 1 into the other.
static scree_status sort_pass(OpenCl* d, const Run* run, cl_mem from, cl_mem to, cl_int shift, int bits)
{
	cl_mem counters = d->pools[POOL_counters];
	cl_uint mask = (1u << bits) - 1;
	TRY(set_arguments(d->sort_count, (cl_mem[]){from, counters, d->table}, 3));
	TRY(set_arguments(d->sort_place, (cl_mem[]){from, to, counters, d->table}, 4));
	TRY(CALL(SetKernelArg, d->sort_count, 3, sizeof *run, run));
	TRY(CALL(SetKernelArg, d->sort_count, 4, sizeof shift, &shift));
	TRY(CALL(SetKernelArg, d->sort_count, 5, sizeof mask, &mask));
	TRY(CALL(SetKernelArg, d->sort_place, 4, sizeof *run, run));
	TRY(CALL(SetKernelArg, d->sort_place, 5, sizeof shift, &shift));
	TRY(CALL(SetKernelArg, d->sort_place, 6, sizeof mask, &mask));
	size_t items = PRIMITIVE_GROUP * groups_for(run->end, SORT_GRAIN, SORT_BLOCKS);
	TRY(launch(d, d->sort_count, items, PRIMITIVE_GROUP));
	return launch(d, d->sort_place, items, PRIMITIVE_GROUP);
}

static scree_status sort_run(OpenCl* d, const Run* run)
{
	int first = run->argument & 255, end = run->argument >> 8;
	int passes = (end - first + SORT_DIGIT_BITS - 1) / SORT_DIGIT_BITS;
	cl_mem from = d->pools[POOL_key], to = d->pools[POOL_key_other];
	for (int pass = 0; pass < passes; ++pass)
	{
		int shift = first + pass * SORT_DIGIT_BITS;
		TRY(sort_pass(d, run, from, to, shift, end - shift < SORT_DIGIT_BITS ? end - shift : SORT_DIGIT_BITS));
		cl_mem swapped = from;
		from = to;
		to = swapped;
	}
	if (passes % 2 == 0)
		return SCREE_OK;

	// a copy is cheaper than a pass more
	TRY(CALL(SetKernelArg, d->sort_return, 3, sizeof *run, run));
	return launch(d, d->sort_return, PRIMITIVE_GROUP * groups_for(run->end, PRIMITIVE_GROUP, 4 * SORT_BLOCKS),
	              PRIMITIVE_GROUP);
}

static scree_status scan_run(OpenCl* d, const Run* run)
{
	size_t items = PRIMITIVE_GROUP * groups_for(run->end, SCAN_GRAIN, SCAN_BLOCKS);
	TRY(CALL(SetKernelArg, d->scan_sum, 3, sizeof *run, run));
	TRY(CALL(SetKernelArg, d->scan_place, 3, sizeof *run, run));
	TRY(launch(d, d->scan_sum, items, PRIMITIVE_GROUP));
	return launch(d, d->scan_place, items, PRIMITIVE_GROUP);
}

scree_status primitive_run(OpenCl* d, const Run* run)
{
	return run->stage == PRIMITIVE_SORT ? sort_run(d, run) : scan_run(d, run);
}
