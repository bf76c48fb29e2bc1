// SPDX-License-Identifier: MIT
// persistent.cl -- one launch that works through many runs of the solver: all groups meet between two runs.
//
// A meeting costs a quarter of a launch. It needs all groups on the device at once, which OpenCL does not promise: the
// host tries it once when it opens a device (PERSISTENT_PROBE), and no wait here is without a bound.
#include "opencl/limits.h"
#include "pools/pools.h"

enum
{
#define X(name, width, box) STAGE_##name,
#include "stages/stages.def"
#undef X
	STAGE_COUNT
};

// Orders this work-item's memory accesses for the whole device, not its group alone, and drops what its first-level
// cache holds. OpenCL C 1.2 has no such fence; where none is known the probe decides whether mem_fence will do.
#ifdef __NV_CL_C_VERSION
#define DEVICE_FENCE() asm volatile("membar.gl;" ::: "memory")
#else
#define DEVICE_FENCE() mem_fence(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE)
#endif

// Waits until so many arrivals of groups are counted. False when that took more than so many spins, here or elsewhere.
INLINE bool meet(volatile __global int* arrived, volatile __global int* fault, __local int* healthy, int arrivals,
                 int spins)
{
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	if (get_local_id(0) == 0)
	{
		DEVICE_FENCE();
		atomic_inc(arrived);
		while (*arrived < arrivals && spins > 0)
			--spins;
		if (*arrived < arrivals)
			*fault = FAULT_BLOWN;
		DEVICE_FENCE();
		*healthy = *fault == 0;
	}
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return *healthy;
}

// Meeting number k of the probe: writes k for a work-item of another group, and looks for the k - 1 that a third wrote.
// The reads are plain and come back to the same places, so that a stale cache shows.
INLINE void probe(__global int* probes, volatile __global int* fault, int k)
{
	int n = (int)get_global_size(0), i = (int)get_global_id(0), group = (int)get_local_size(0);
	__global int* now = probes + (k & 1) * n;
	__global const int* last = probes + (~k & 1) * n;
	if (k > 0 && last[(i + group) % n] != k - 1)
		*fault = FAULT_STALE;
	now[(i + 2 * group) % n] = k;
}

INLINE int run_end(Run run, const Pools* p)
{
	return run.count < 0 ? run.end : min(run.end, ((volatile __global int*)p->counters)[run.count]);
}

// list holds PERSISTENT_HEADER ints, of which the first is zero, then count runs. A run without items is passed over
// without meeting, and the next is fetched early, so no run may change the counter that bounds a later one of the list.
__kernel void persistent(POOL_ARGUMENTS Step step, __global int* list, int count, __global int* probes, int spins)
{
	__local int healthy;
	Pools pools = {POOL_NAMES step, 0};
	volatile __global int* fault = &pools.counters->fault;
	__global const Run* runs = (__global const Run*)(list + PERSISTENT_HEADER);
	int begin = (int)get_global_id(0), stride = (int)get_global_size(0), arrivals = 0;
	Run next = runs[0];
	int next_end = run_end(next, &pools);
	for (int k = 0; k < count; ++k)
	{
		// the next run is fetched while this one is worked on
		Run run = next;
		int end = next_end;
		next = runs[min(k + 1, count - 1)];
		next_end = run_end(next, &pools);
		if (run.begin >= end)
			continue;
		pools.argument = run.argument;
		for (int i = run.begin + begin; i < end; i += stride)
		{
			switch (run.stage)
			{
#define SOLVER_transform(name)
#define SOLVER_broad_phase(name)
#define SOLVER_narrow_phase(name)
#define SOLVER_color(name)
#define SOLVER_finalize(name)
#define SOLVER_solve(name)                                                                                             \
	case STAGE_##name:                                                                                                 \
		name##_item(&pools, i);                                                                                        \
		break;
#define X(name, width, box) SOLVER_##box(name)
#include "stages/stages.def"
#undef X
			case PERSISTENT_PROBE:
				probe(probes, fault, run.argument);
				break;
			}
		}
		arrivals += (int)get_num_groups(0);
		if (!meet((volatile __global int*)list, fault, &healthy, arrivals, spins))
			return;
	}
}
