// SPDX-License-Identifier: MIT
// persistent.cl -- one launch that works through a whole list of runs: all groups meet after each that has items.
//
// A run may change the counter that bounds a later one of the list: bounds are read after each meeting.
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
	STAGE_COUNT,
	PRIMITIVE_SORT = STAGE_COUNT,
	PRIMITIVE_SCAN
};

// Orders this work-item's memory accesses for the whole device, not its group alone, and drops what its first-level
// cache holds. OpenCL C 1.2 has no such fence; where none is known the probe decides whether mem_fence will do.
#ifdef __NV_CL_C_VERSION
#define DEVICE_FENCE() asm volatile("membar.gl;" ::: "memory")
#else
#define DEVICE_FENCE() mem_fence(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE)
#endif

typedef struct // of all groups
{
	volatile __global int* arrived; // goes on from launch to launch
	volatile __global int* fault;
	volatile __local int* healthy;
	int arrivals; // when the last meeting was over
	int spins;
} Meeting;

// Waits until all groups have arrived. False when that took more than so many spins, here or elsewhere.
INLINE bool meet(Meeting* m)
{
	m->arrivals = (int)((uint)m->arrivals + (uint)get_num_groups(0));
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	if (get_local_id(0) == 0)
	{
		DEVICE_FENCE();
		atomic_inc(m->arrived);
		int spins = m->spins;
		while ((int)((uint)*m->arrived - (uint)m->arrivals) < 0 && spins > 0)
			--spins;
		if (spins <= 0)
			*m->fault = FAULT_BLOWN;
		DEVICE_FENCE();
		*m->healthy = *m->fault == 0;
	}
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return *m->healthy;
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

// As the launches of primitives.c; the parts of groups that are not there are taken by those that are.
INLINE bool sort_together(const Pools* p, Run run, __global uint* table, __local Bench* bench, Meeting* m)
{
	uint n = item_count(run, (__global const int*)p->counters), first = (uint)get_group_id(0), groups = (uint)get_num_groups(0);
	int from = run.argument & 255, end = run.argument >> 8;
	__global Word64 *key = p->key, *other = p->key_other;
	if (n <= SORT_FEW)
	{
		// a pass takes two meetings, and there are up to eight
		sort_few(key, other, n, from, end, bench);
		if (!meet(m))
			return false;
		key = other;
		end = from;
	}
	for (int shift = from; shift < end; shift += SORT_DIGIT_BITS)
	{
		uint mask = (1u << min(SORT_DIGIT_BITS, end - shift)) - 1;
		for (uint block = first; block < SORT_BLOCKS; block += groups)
			sort_count_part(key, n, table, block, shift, mask, bench->sum);
		if (!meet(m))
			return false;
		for (uint block = first; block < SORT_BLOCKS; block += groups)
			sort_place_part(key, other, n, table, block, shift, mask, bench);
		if (!meet(m))
			return false;
		__global Word64* swapped = key;
		key = other;
		other = swapped;
	}
	if (key != p->key)
		for (uint i = (uint)get_global_id(0); i < n; i += (uint)get_global_size(0))
			p->key[i] = key[i];
	return true;
}

INLINE bool scan_together(const Pools* p, Run run, __global uint* table, __local uint* sum, Meeting* m)
{
	uint n = item_count(run, (__global const int*)p->counters), first = (uint)get_group_id(0), groups = (uint)get_num_groups(0);
	for (uint block = first; block < SCAN_BLOCKS; block += groups)
		scan_sum_part(p->scan, n, table, block, sum);
	if (!meet(m))
		return false;
	for (uint block = first; block < SCAN_BLOCKS; block += groups)
		scan_place_part(p->scan, n, table, block, sum);
	return true;
}

// Items of a run, each by one work-item. What takes a group is launched by itself: with it compilation for
// a CPU takes twice as long.
#define CASE_ONE(name)                                        \
	case STAGE_##name:                                        \
		for (int i = run.begin + begin; i < end; i += stride) \
			name##_item(&pools, i);                           \
		break;
#define CASE_WIDE(name) CASE_ONE(name)
#define CASE_GROUP(name)

INLINE int run_end(Run run, const Pools* p)
{
	return run.count < 0 ? run.end : min(run.end, ((volatile __global int*)p->counters)[run.count]);
}

// list holds PERSISTENT_HEADER ints, the first two for meetings, then count runs: one a work-item of a group at most. Each
// work-item keeps a run and reads its bound after every meeting, so that all bounds together cost one look at memory,
// and runs without items cost nothing.
__kernel void persistent(POOL_ARGUMENTS Step step, __global int* list, int count, __global uint* table,
                         __global int* probes, int spins)
{
	volatile __local int healthy, found;
	__local Run chosen;
	__local Bench bench;
	Pools pools = {POOL_NAMES step, 0};
	int lane = (int)get_local_id(0), begin = (int)get_global_id(0), stride = (int)get_global_size(0);
	Run mine = {0, 0, 0, -1, 0};
	if (lane < count)
		mine = ((__global const Run*)(list + PERSISTENT_HEADER))[lane];
	volatile __global int* met = list;
	Meeting m = {met, &pools.counters->fault, &healthy, met[1], spins};
	for (int next = 0;;)
	{
		if (lane == 0)
			found = count;
		barrier(CLK_LOCAL_MEM_FENCE);
		if (lane >= next && mine.begin < run_end(mine, &pools))
			atomic_min(&found, lane);
		barrier(CLK_LOCAL_MEM_FENCE);
		if (found == lane)
			chosen = mine;
		barrier(CLK_LOCAL_MEM_FENCE);
		if (found == count)
			break;
		next = found + 1;
		Run run = chosen;
		int end = run_end(run, &pools);
		pools.argument = run.argument;
		bool well = true;
		switch (run.stage)
		{
#define X(name, width, box) CASE_##width(name)
#include "stages/stages.def"
#undef X
		case PRIMITIVE_SORT:
			well = sort_together(&pools, run, table, &bench, &m);
			break;
		case PRIMITIVE_SCAN:
			well = scan_together(&pools, run, table, bench.sum, &m);
			break;
		case PERSISTENT_PROBE:
			probe(probes, m.fault, run.argument);
			break;
		}
		if (!well)
			return;
		if (next == count)
			break;
		if (!meet(&m))
			return;
	}
	// after a meeting all have read where it began
	if (begin == 0)
		met[1] = m.arrivals;
}
