// SPDX-License-Identifier: MIT
// bay_solve.c -- launches the solve of a batch as one kernel (bay_solve.cl).
#include "opencl/forms/bay_solve.h"
#include "opencl/buffer.h"
#include "opencl/forms/relay.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "platform/error.h"

#define GROUPS_A_UNIT 4 // number of work-groups per compute unit below which a group gets fewer worlds

static const char* const names[BAY_KERNELS] = {"bay_solve", "bay_solve_hinges", "bay_solve_joints", "bay_solve_varied"};

scree_status bay_solve_open(OpenCl* d)
{
	d->solves_bays = true;
	for (int k = 0; k < BAY_KERNELS; ++k)
	{
		TRY(kernel_create(d, names[k], BAY_GROUP, &d->bay_kernels[k]));
		d->solves_bays &= d->bay_kernels[k].group == BAY_GROUP;
	}
	return SCREE_OK;
}

void bay_solve_close(OpenCl* d)
{
	for (int k = 0; k < BAY_KERNELS; ++k)
		RELEASE(d->failure, Kernel, d->bay_kernels[k].kernel);
}

scree_status bay_solve_bind(OpenCl* d, Per per)
{
	for (int k = 0; k < BAY_KERNELS && d->solves_bays; ++k)
		TRY(kernel_bind(d, per, &d->bay_kernels[k]));
	return SCREE_OK;
}

bool bay_solve_fits(const OpenCl* d, const Step* step, const Solve* solve)
{
	const Bays* bays = &step->bays;
	return bays->worlds > 0 && bays->bodies <= BAY_BODIES && solve->counters->hubs == 0 && d->solves_bays;
}

static cl_int places_of(const Solve* solve) { return solve->places > 0 ? solve->places : solve_constraints(solve); }

scree_status bay_solve_reserve(OpenCl* d, const Solve* solve)
{
	return scratch_reserve(d, &d->relay.stream, (size_t)places_of(solve) * STREAM_FLOAT4S * sizeof(cl_float4) + 1);
}

// Returns the number of worlds of a work-group. live: number of worlds that are stepped.
static cl_int group_worlds(const OpenCl* d, cl_int live)
{
	const Bays* bays = &d->constants.step.bays;
	cl_int most = BAY_BODIES / bays->bodies, groups = GROUPS_A_UNIT * d->device.about.compute_units,
	       share = (live + groups - 1) / groups;
	return share < most ? share : most;
}

scree_status bay_solve_run(OpenCl* d, const Solve* solve)
{
	const Step* step = &d->constants.step;
	int which = step->bays.varied ? BAY_VARIED : !step->joints ? BAY_COLORS : solve_hinges(d) ? BAY_HINGES : BAY_JOINTS;
	Kernel* kernel = &d->bay_kernels[which];
	cl_int stride = places_of(solve), passes = schedule_passes(solve->substeps, solve->bounces);
	cl_int live = solve->bodies / step->bays.bodies, bays = group_worlds(d, live);
	const cl_int* values[] = {&stride, &bays, &solve->substeps, &passes, &solve->bound};
	TRY(kernel_step(d, kernel));
	TRY(CALL(d->failure, SetKernelArg, kernel->kernel, ARGUMENT_STEP + 1, sizeof(cl_mem), &d->relay.stream.buffer));
	for (cl_uint k = 0; k < 5; ++k)
		TRY(CALL(d->failure, SetKernelArg, kernel->kernel, ARGUMENT_STEP + 2 + k, sizeof(cl_int), values[k]));
	size_t groups = ((size_t)live + (size_t)bays - 1) / (size_t)bays;
	return launch(d, kernel->kernel, groups * kernel->group, kernel->group);
}
