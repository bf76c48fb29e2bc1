// SPDX-License-Identifier: MIT
// launch.h -- sets the arguments of kernels that take all pools, and launches them.
#ifndef OPENCL_LAUNCH_H
#define OPENCL_LAUNCH_H
#include "opencl/opencl_state.h"

// bytes: each pool begins at a multiple of this in its buffer
#define POOL_ALIGNMENT 256

// kernel arguments that follow the buffers
enum
{
	ARGUMENT_CAPACITIES = BUFFERS,
	ARGUMENT_STEP,
	ARGUMENT_FIRST // first argument that only some of these kernels have
};

// Returns the maximum number of work-items per work-group of a compiled kernel. It depends on the kernel's registers.
scree_status kernel_group_most(const OpenCl* d, cl_kernel kernel, size_t* most);

// Creates a kernel that runs only in work-groups of `group` work-items. Fails if the device permits fewer.
scree_status kernel_create_fixed(OpenCl* d, const char* name, size_t group, cl_kernel* kernel);

// Creates a kernel that takes all pools, and sets the size of its work-groups, at most `largest` work-items.
scree_status kernel_create(OpenCl* d, const char* name, size_t largest, Kernel* kernel);

// Return the buffer of a pool, and the offset of the pool in this buffer, in bytes.
cl_mem pool_buffer(const OpenCl* d, PoolId pool);
size_t pool_offset(const OpenCl* d, PoolId pool);

// Sets arguments of a kernel after the buffer of a kind of item was replaced: this buffer, and all capacities.
scree_status kernel_bind(OpenCl* d, Per per, const Kernel* kernel);

// Sets the constants of the step for all later launches.
void step_set(OpenCl* d, const Step* step);

// Sets the step as an argument of a kernel, if it has changed since the last call for this kernel.
scree_status kernel_step(OpenCl* d, Kernel* kernel);

// Launch a run. kernel_run_within gives a work-group items_a_group items, or more if there would otherwise be more than
// groups_a_unit work-groups per compute unit.
scree_status kernel_run(OpenCl* d, const Run* run);
scree_status kernel_run_within(OpenCl* d, const Run* run, size_t items_a_group, size_t groups_a_unit);

#endif
