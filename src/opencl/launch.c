// SPDX-License-Identifier: MIT
// launch.c -- sets the arguments of kernels that take all pools, and launches them.
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "platform/error.h"
#include <string.h>

// least number of work-items of a group: those that a GPU executes together
#define SMALL_GROUP ((size_t)32)

// maximum number of work-groups per compute unit; in longer runs, a work-item executes several items
#define GROUPS_A_UNIT 64

scree_status kernel_group_most(const OpenCl* d, cl_kernel kernel, size_t* most)
{
	*most = 0;
	return CALL(d->failure, GetKernelWorkGroupInfo, kernel, d->device.id, CL_KERNEL_WORK_GROUP_SIZE, sizeof *most, most,
	            NULL);
}

static scree_status create(OpenCl* d, const char* name, cl_kernel* kernel)
{
	cl_int error;
	CREATE(d->failure, *kernel, error, Kernel, d->program, name);
	if (error)
	{
		context_note(d->failure, error);
		return fail(SCREE_ERROR_DEVICE_FAILED, "clCreateKernel of %s: %s (%d)", name, opencl_error_name(error),
		            (int)error);
	}
	return SCREE_OK;
}

scree_status kernel_create_fixed(OpenCl* d, const char* name, size_t group, cl_kernel* kernel)
{
	size_t most;
	TRY(create(d, name, kernel));
	TRY(kernel_group_most(d, *kernel, &most));
	if (most < group)
		return fail(SCREE_ERROR_NO_DEVICE,
		            "Device %s is refused: its work-groups of kernel %s hold at most %zu work-items; Scree needs %zu.",
		            d->device.about.name, name, most, group);
	return SCREE_OK;
}

scree_status kernel_create(OpenCl* d, const char* name, size_t largest, Kernel* kernel)
{
	size_t most, multiple = 1;
	TRY(create(d, name, &kernel->kernel));
	TRY(kernel_group_most(d, kernel->kernel, &most));
	if (most == 0)
		return fail(SCREE_ERROR_NO_DEVICE, "Device %s is refused: it cannot run kernel %s.", d->device.about.name,
		            name);
	TRY(CALL(d->failure, GetKernelWorkGroupInfo, kernel->kernel, d->device.id,
	         CL_KERNEL_PREFERRED_WORK_GROUP_SIZE_MULTIPLE, sizeof multiple, &multiple, NULL));
	kernel->group = most < largest ? most : largest;
	if (multiple > 1 && kernel->group > multiple)
		kernel->group -= kernel->group % multiple;
	return SCREE_OK;
}

cl_mem pool_buffer(const OpenCl* d, PoolId pool) { return d->buffers[d->home[pool_info[pool].per]]; }

size_t pool_offset(const OpenCl* d, PoolId pool)
{
	Per per = pool_info[pool].per;
	return d->begin[per] + d->before[pool] * (size_t)d->room[per];
}

scree_status kernel_bind(OpenCl* d, Per per, const Kernel* kernel)
{
	// an argument (cmake/embed.cmake): offsets of the kinds that are in the buffer of another kind; capacities of all
	// kinds
	struct
	{
		cl_uint begins[PER_COUNT - BUFFERS];
		cl_int capacities[PER_COUNT];
	} capacities = {0};
	for (int i = 0; i < PER_COUNT; ++i)
	{
		if (d->home[i] != (Per)i)
			capacities.begins[d->argument[i]] = (cl_uint)(d->begin[i] / POOL_ALIGNMENT);
		capacities.capacities[d->place[i]] = d->room[i];
	}
	Per home = d->home[per];
	TRY(CALL(d->failure, SetKernelArg, kernel->kernel, (cl_uint)d->argument[home], sizeof(cl_mem), &d->buffers[home]));
	return CALL(d->failure, SetKernelArg, kernel->kernel, ARGUMENT_CAPACITIES, sizeof capacities, &capacities);
}

void step_set(OpenCl* d, const Step* step)
{
	if (memcmp(&d->constants.step, step, sizeof *step) == 0)
		return;
	d->constants.step = *step;
	++d->constants.version;
}

scree_status kernel_step(OpenCl* d, Kernel* kernel)
{
	if (kernel->version == d->constants.version)
		return SCREE_OK;
	TRY(CALL(d->failure, SetKernelArg, kernel->kernel, ARGUMENT_STEP, sizeof d->constants.step, &d->constants.step));
	kernel->version = d->constants.version;
	return SCREE_OK;
}

// Returns the kernel, or its variant (PLAIN_*) if the world lacks the features that the variant leaves out.
static Kernel* kernel_function(OpenCl* d, int kernel)
{
	const Step* step = &d->constants.step;
	if (kernel == KERNEL_narrow_phase && !step->small && !step->belts && !step->segments)
		return &d->plain[PLAIN_NARROW_PHASE];
	if (kernel == KERNEL_continuous && !step->rules && !step->asks && step->material_pairs == 0)
		return &d->plain[PLAIN_CONTINUOUS];
	return &d->kernels[kernel];
}

// Returns the number of work-items per group. A chain or a branch in a batch has at most as many joints as a world, so a large
// group would have no work for most of its items, and would leave no room for other groups.
static size_t group_size(const OpenCl* d, const Kernel* kernel, int kernel_id)
{
	const Bays* bays = &d->constants.step.bays;
	size_t joints = (size_t)1 << bays->joint_bits, enough = joints < SMALL_GROUP ? SMALL_GROUP : joints;
	bool joined = kernel_id >= KERNEL_chain_begin && kernel_id <= KERNEL_branch_end;
	return joined && bays->worlds > 0 && enough < kernel->group ? enough : kernel->group;
}

scree_status kernel_run(OpenCl* d, const Run* run)
{
	size_t group = kernel_function(d, run->kernel_id)->group;
	return kernel_run_within(d, run, kernel_widths[run->kernel_id] >= WIDTH_GROUP ? 1 : group, GROUPS_A_UNIT);
}

scree_status kernel_run_within(OpenCl* d, const Run* run, size_t items_a_group, size_t groups_a_unit)
{
	Kernel* kernel = kernel_function(d, run->kernel_id);
	d->timing.stage = kernel_stages[run->kernel_id];
	TRY(kernel_step(d, kernel));
	TRY(CALL(d->failure, SetKernelArg, kernel->kernel, ARGUMENT_FIRST, sizeof *run, run));
	size_t items = (size_t)(run->end - run->begin);
	size_t groups = (items + items_a_group - 1) / items_a_group;
	size_t most = (size_t)d->device.about.compute_units * groups_a_unit;
	size_t group = group_size(d, kernel, run->kernel_id);
	return launch(d, kernel->kernel, (groups < most ? groups : most) * group, group);
}
