// SPDX-License-Identifier: MIT
// launch.h -- kernels that take all pools: their arguments and launches.
#ifndef OPENCL_LAUNCH_H
#define OPENCL_LAUNCH_H
#include "opencl/opencl_state.h"

enum
{
#define SHARES(kind, with) -1
	BUFFERS = PER_COUNT
#include "pools/buffers.def"
#undef SHARES
};

// kernel arguments that follow the buffers
enum
{
	ARGUMENT_CAPACITIES = BUFFERS,
	ARGUMENT_STEP,
	ARGUMENT_FIRST // the first of the kernel's own
};

// Creates a kernel that takes all pools. Its work-groups have at most largest work-items.
scree_status kernel_create(OpenCl* d, const char* name, size_t largest, Kernel* kernel);

// Return the buffer of a pool, and the byte at which the pool begins in it.
cl_mem pool_buffer(const OpenCl* d, PoolId pool);
size_t pool_offset(const OpenCl* d, PoolId pool);

// Sets the buffer of a kind of item as an argument of a kernel that takes all pools, after the buffer was replaced.
scree_status kernel_bind(OpenCl* d, Per per, const Kernel* kernel);

// Sets the constants of the step for all later launches.
void step_set(OpenCl* d, const Step* step);

// Sets the step as an argument of a kernel that takes all pools, if it changed.
scree_status kernel_step(OpenCl* d, Kernel* kernel);

// Launches a run of a kernel. kernel_run_within: a work-group processes items_a_group items, or more if there would be
// more than groups_a_unit groups per compute unit.
scree_status kernel_run(OpenCl* d, const Run* run);
scree_status kernel_run_within(OpenCl* d, const Run* run, size_t items_a_group, size_t groups_a_unit);

#endif
