// SPDX-License-Identifier: MIT
// relay.c -- launches a whole solve at once (relay.cl), where the device can.
#include "error.h"
#include "opencl/opencl.h"
#include <stdlib.h>
#include <string.h>

// Beyond this many constraints launches are faster.
#define RELAY_CONSTRAINTS 1000000

// Bounds of a wait, in looks at a word of half a microsecond or so: 2 s, and 30 ms for the probe.
#define SPINS        (1 << 22)
#define PROBE_SPINS  (1 << 16)
#define PROBE_ROUNDS 16

// arguments behind the step
enum
{
	RELAY_ROWS = ARGUMENT_STEP + 1,
	RELAY_NOTE,
	RELAY_COUNT,
	RELAY_SUBSTEPS,
	RELAY_PASSES,
	RELAY_CLEANSE,
	RELAY_BOUND,
	RELAY_SPINS,
	END_ROWS = RELAY_ROWS,
	END_BODIES,
	END_SUBSTEPS,
	END_PASSES,
	END_BOUND
};

// Room for the rows of so many bodies, zeroed.
static scree_status rows_reserve(OpenCl* d, int count)
{
	if (count <= d->row_count)
		return SCREE_OK;
	TRY(finish(d));
	if (d->rows)
		opencl.ReleaseMemObject(d->rows);
	d->rows = NULL;
	d->row_count = 0;
	int room = count + count / 2;
	TRY(buffer_create(d, (size_t)room * RELAY_WORDS * sizeof(cl_ulong), &d->rows));
	d->row_count = room;
	TRY(CALL(SetKernelArg, d->relay_end.kernel, END_ROWS, sizeof d->rows, &d->rows));
	return CALL(SetKernelArg, d->relay.kernel, RELAY_ROWS, sizeof d->rows, &d->rows);
}

// Room for the notes of so many constraints, if they do not stay in registers.
static scree_status notes_reserve(OpenCl* d, int count)
{
	if (d->notes && (count <= d->note_count || count <= d->relay_groups * (int)d->relay.group))
		return SCREE_OK;
	TRY(finish(d));
	if (d->notes)
		opencl.ReleaseMemObject(d->notes);
	d->notes = NULL;
	d->note_count = 0;
	int room = count + count / 2 + 1;
	TRY(buffer_create(d, (size_t)room * RELAY_NOTES * sizeof(cl_float4), &d->notes));
	d->note_count = room;
	return CALL(SetKernelArg, d->relay.kernel, RELAY_NOTE, sizeof d->notes, &d->notes);
}

// Whether work-items really run together, each on its own.
static scree_status probe(OpenCl* d, cl_kernel kernel, cl_mem rows, cl_mem fault, bool* runs)
{
	cl_int rounds = PROBE_ROUNDS, spins = PROBE_SPINS, found = 0;
	TRY(CALL(SetKernelArg, kernel, 0, sizeof rows, &rows));
	TRY(CALL(SetKernelArg, kernel, 1, sizeof fault, &fault));
	TRY(CALL(SetKernelArg, kernel, 2, sizeof rounds, &rounds));
	TRY(CALL(SetKernelArg, kernel, 3, sizeof spins, &spins));
	TRY(launch(d, kernel, (size_t)d->relay_groups * d->relay.group, d->relay.group));
	TRY(CALL(EnqueueReadBuffer, d->queue, fault, CL_TRUE, 0, sizeof found, &found, 0, NULL, NULL));
	*runs = found == 0;
	if (found)
		log_sentence(SCREE_LOG_INFO, "%s: %s; the solver does without the relay.", d->device.about.name,
		             found == FAULT_BLOWN ? "work-items do not run together" : "words arrive in pieces");
	return SCREE_OK;
}

scree_status relay_open(OpenCl* d)
{
	if (d->most_groups == 0)
		return SCREE_OK;
	size_t most = 0;
	TRY(CALL(GetKernelWorkGroupInfo, d->relay.kernel, d->device.id, CL_KERNEL_WORK_GROUP_SIZE, sizeof most, &most,
	         NULL));
	// a CPU runs work-items to their end one after the other: only one is sure to run, which serves tests
	if (d->device.type & CL_DEVICE_TYPE_CPU)
		d->relay.group = 1;
	d->relay_groups = d->device.type & CL_DEVICE_TYPE_CPU ? 1 : d->device.about.units * (int)(most / d->relay.group);

	cl_int error;
	cl_mem rows = NULL, fault = NULL;
	bool runs = false;
	cl_kernel kernel = opencl.CreateKernel(d->program, "relay_probe", &error);
	scree_status status = opencl_check("clCreateKernel", error);
	if (!status)
		status = buffer_create(d, 2 * sizeof(cl_ulong) * (size_t)d->relay_groups * d->relay.group, &rows);
	if (!status)
		status = buffer_create(d, sizeof(cl_int), &fault);
	if (!status)
		status = probe(d, kernel, rows, fault, &runs);
	if (!runs)
		d->relay_groups = 0;
	if (rows)
		opencl.ReleaseMemObject(rows);
	if (fault)
		opencl.ReleaseMemObject(fault);
	if (kernel)
		opencl.ReleaseKernel(kernel);
	return status;
}

void relay_close(OpenCl* d)
{
	cl_kernel kernels[] = {d->relay.kernel, d->relay_end.kernel};
	for (int i = 0; i < 2; ++i)
		if (kernels[i])
			opencl.ReleaseKernel(kernels[i]);
	if (d->rows)
		opencl.ReleaseMemObject(d->rows);
	if (d->notes)
		opencl.ReleaseMemObject(d->notes);
}

int relay_length(const OpenCl* d, const Run* runs, int count)
{
	if (d->relay_groups == 0 || runs[0].stage != STAGE_solve_begin)
		return 0;
	for (int k = 0; k < count; ++k)
		switch (runs[k].stage)
		{
		case STAGE_overflow_key:
			return 0; // sums over many constraints
		case STAGE_prepare:
			if (runs[k].end > RELAY_CONSTRAINTS && !d->any_size)
				return 0;
			break;
		case STAGE_finalize:
			return k + 1;
		}
	return 0;
}

scree_status relay_run(OpenCl* d, const Run* runs, int count)
{
	cl_int constraints = 0, substeps = 0, passes = 1, bodies = runs[count - 1].end, spins = SPINS;
	cl_int cleanse = 0, bound = runs->count; // of all runs alike
	bool bounce = false;
	for (int k = 0; k < count; ++k)
	{
		constraints = runs[k].stage == STAGE_prepare ? runs[k].end : constraints;
		substeps += runs[k].stage == STAGE_integrate_velocity;
		cleanse |= runs[k].stage == STAGE_cleanse;
		bounce = bounce || runs[k].stage == STAGE_bounce;
	}
	passes += 2 * substeps + bounce;
	TRY(rows_reserve(d, bodies));
	TRY(notes_reserve(d, constraints));

	cl_kernel kernel = d->relay.kernel;
	TRY(kernel_step(d, &d->relay));
	TRY(CALL(SetKernelArg, kernel, RELAY_COUNT, sizeof constraints, &constraints));
	TRY(CALL(SetKernelArg, kernel, RELAY_SUBSTEPS, sizeof substeps, &substeps));
	TRY(CALL(SetKernelArg, kernel, RELAY_PASSES, sizeof passes, &passes));
	TRY(CALL(SetKernelArg, kernel, RELAY_CLEANSE, sizeof cleanse, &cleanse));
	TRY(CALL(SetKernelArg, kernel, RELAY_BOUND, sizeof bound, &bound));
	TRY(CALL(SetKernelArg, kernel, RELAY_SPINS, sizeof spins, &spins));
	size_t group = d->relay.group, groups = ((size_t)constraints + group - 1) / group;
	groups = groups < (size_t)d->relay_groups ? groups : (size_t)d->relay_groups;
	d->box = BOX_solve;
	TRY(launch(d, kernel, (groups ? groups : 1) * group, group));

	kernel = d->relay_end.kernel;
	TRY(kernel_step(d, &d->relay_end));
	TRY(CALL(SetKernelArg, kernel, END_BODIES, sizeof bodies, &bodies));
	TRY(CALL(SetKernelArg, kernel, END_SUBSTEPS, sizeof substeps, &substeps));
	TRY(CALL(SetKernelArg, kernel, END_PASSES, sizeof passes, &passes));
	TRY(CALL(SetKernelArg, kernel, END_BOUND, sizeof bound, &bound));
	group = d->relay_end.group;
	groups = ((size_t)bodies + group - 1) / group;
	d->box = BOX_finalize;
	return launch(d, kernel, (groups ? groups : 1) * group, group);
}
