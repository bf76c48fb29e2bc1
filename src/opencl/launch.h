// SPDX-License-Identifier: MIT
// launch.h -- kernels that take all pools: their arguments and launches, and lists of runs.
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

// arguments of a kernel after the buffers
enum
{
	ARGUMENT_CAPACITIES = BUFFERS,
	ARGUMENT_STEP,
	ARGUMENT_FIRST // of the kernel's own
};

// Creates a kernel that takes all pools, and sets the size of its work-groups: at most largest.
scree_status kernel_create(OpenCl* d, const char* name, size_t largest, Kernel* kernel);

// the buffer of a pool, and where the pool begins in it, in bytes
cl_mem pool_buffer(const OpenCl* d, PoolId pool);
size_t pool_offset(const OpenCl* d, PoolId pool);

// Sets the buffer of a kind, after it has been replaced, in a kernel that takes all pools.
scree_status kernel_bind(OpenCl* d, Per per, const Kernel* kernel);

// Sets the constants of a step for all later launches.
void step_set(OpenCl* d, const Step* step);

// Sets the step of a kernel that takes all pools, if it changed.
scree_status kernel_step(OpenCl* d, Kernel* kernel);

// Launches a run of a stage; with so many items to a work-group, as long as there are no more groups per compute unit than this.
scree_status kernel_run(OpenCl* d, const Run* run);
scree_status kernel_run_within(OpenCl* d, const Run* run, size_t items_a_group, size_t groups_a_unit);

#endif
