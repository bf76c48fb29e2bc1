// SPDX-License-Identifier: MIT
// persistent.cl -- one launch that works through a whole list of runs: all groups device_barrier after each that has items.
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

// Whether there may be several groups: not on a CPU, whose compiler takes many minutes for meetings that depend on anything.
#ifdef ONE_GROUP
#define SEVERAL false
#else
#define SEVERAL true
#endif

typedef struct // of all groups
{
	volatile __global int* arrived; // goes on from launch to launch
	volatile __global int* fault;
	volatile BENCH int* healthy;
	int arrivals; // when the last meeting was over
	int spins;
} DeviceBarrier;

// Waits until all groups have arrived. False when that took more than so many spins, here or elsewhere.
INLINE bool device_barrier(DeviceBarrier* m)
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
			*m->fault = FAULT_TIMEOUT;
		DEVICE_FENCE();
		*m->healthy = *m->fault == 0;
	}
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return *m->healthy;
}

// The first group waits here until all others have arrived at the next meeting. False as in device_barrier.
INLINE bool device_barrier_await(const DeviceBarrier* m)
{
	if (get_local_id(0) == 0)
	{
		int spins = m->spins;
		uint others = (uint)m->arrivals + (uint)get_num_groups(0) - 1u;
		while ((int)((uint)*m->arrived - others) < 0 && spins > 0)
			--spins;
		if (spins <= 0)
			*m->fault = FAULT_TIMEOUT;
		DEVICE_FENCE();
		*m->healthy = *m->fault == 0;
	}
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return *m->healthy;
}

// DeviceBarrier number k of the probe: writes k for a work-item of another group, and looks for the k - 1 that a third wrote.
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

// A meeting, of the group that is alone with its run where it is.
INLINE bool run_barrier(DeviceBarrier* m, bool alone)
{
	if (!SEVERAL || !alone)
		return device_barrier(m);
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return true;
}

// As the launches of primitives.c; the parts of groups that are not there are taken by those that are.
INLINE bool persistent_sort(const Pools* p, Run run, __global uint* table, BENCH Bench* bench, DeviceBarrier* m, bool alone)
{
	uint n = item_count(run, (__global const int*)p->counters), part = part_size(n, SORT_BLOCKS, SORT_GRAIN);
	uint first = (uint)get_group_id(0), groups = alone ? 1u : (uint)get_num_groups(0), blocks = (n + part - 1) / part;
	int from = run.argument & 255, end = run.argument >> 8;
	__global Word64 *key = p->key, *other = p->key_other;
	if (n <= SORT_FEW && !alone)
	{
		// a pass takes two meetings, and there are up to eight
		sort_few(key, other, n, from, end, bench);
		if (!device_barrier(m))
			return false;
		key = other;
		end = from;
	}
	for (int shift = from; shift < end; shift += SORT_DIGIT_BITS)
	{
		uint mask = (1u << min(SORT_DIGIT_BITS, end - shift)) - 1;
		for (uint block = first; block < blocks; block += groups)
			sort_count_part(key, n, table, block, shift, mask, bench->sum);
		if (!run_barrier(m, alone))
			return false;
		for (uint block = first; block < blocks; block += groups)
			sort_place_part(key, other, n, table, block, shift, mask, bench);
		if (!run_barrier(m, alone))
			return false;
		__global Word64* swapped = key;
		key = other;
		other = swapped;
	}
	if (key != p->key)
		for (uint i = (uint)get_global_id(0); i < n; i += groups * PERSISTENT_GROUP)
			p->key[i] = key[i];
	return true;
}

INLINE bool persistent_scan(const Pools* p, Run run, __global uint* table, BENCH uint* sum, DeviceBarrier* m)
{
	uint n = item_count(run, (__global const int*)p->counters), first = (uint)get_group_id(0), groups = (uint)get_num_groups(0);
	for (uint block = first; block < SCAN_BLOCKS; block += groups)
		scan_sum_part(p->scan, n, table, block, sum);
	if (!device_barrier(m))
		return false;
	for (uint block = first; block < SCAN_BLOCKS; block += groups)
		scan_place_part(p->scan, n, table, block, sum);
	return true;
}

// Items of a run, each by one work-item. What takes a group is launched by itself: with it compilation for
// a CPU takes twice as long.
#define CASE_ONE(name)                                        \
	case STAGE_##name:                                        \
		for (int i = run.begin + from; i < end; i += by)      \
			name##_item(&pools, i);                           \
		break;
#define CASE_WIDE(name) CASE_ONE(name)
#define CASE_GROUP(name)

INLINE int run_end(Run run, const Pools* p)
{
	return run.count < 0 ? run.end : min(run.end, ((volatile __global int*)p->counters)[run.count]);
}

// Whether the first group is faster alone than all with a meeting behind.
INLINE bool takes_one_group(Run run, int end)
{
	int most = run.stage == PRIMITIVE_SORT ? SORT_GRAIN : run.stage < STAGE_COUNT && run.stage >= 0 ? PERSISTENT_GROUP : 0;
	return end - run.begin <= most;
}

// list holds PERSISTENT_HEADER ints, the first two for meetings and one for the first group to say where it has come to,
// then count runs: one a work-item of a group at most. Each work-item keeps a run and reads its bound after every meeting,
// so that all bounds together cost one look at memory, and runs without items cost nothing.
//
// The first group does short runs alone as long as one follows the other, while the rest are at the meeting behind them. It
// begins when they all are, for bounds change as soon as it does.
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
	DeviceBarrier m = {met, &pools.counters->fault, &healthy, met[1], spins};
	bool single = SEVERAL && get_num_groups(0) == 1, alone = single;
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
		next = found;
		Run run = chosen;
		int end = next < count ? run_end(run, &pools) : 0;
		bool shares = next == count || !takes_one_group(run, end);
		if (SEVERAL && alone && shares && !single)
		{
			if (lane == 0)
				met[2] = next;
			alone = false;
			if (!device_barrier(&m))
				return;
		}
		if (next == count)
			break;
		if (SEVERAL && !alone && !shares)
		{
			alone = get_group_id(0) == 0;
			if (!(alone ? device_barrier_await(&m) : device_barrier(&m)))
				return;
			if (!alone)
			{
				next = met[2];
				continue;
			}
		}
		++next;
		int from = alone ? lane : begin, by = alone ? (int)get_local_size(0) : stride;
		pools.argument = run.argument;
		bool ok = true;
		switch (run.stage)
		{
#define X(name, width, box) CASE_##width(name)
#include "stages/stages.def"
#undef X
		case PRIMITIVE_SORT:
			ok = persistent_sort(&pools, run, table, &bench, &m, alone);
			break;
		case PRIMITIVE_SCAN:
			ok = persistent_scan(&pools, run, table, bench.sum, &m);
			break;
		case PERSISTENT_PROBE:
			probe(probes, m.fault, run.argument);
			break;
		}
		if (!ok)
			return;
		if (!alone && next == count)
			break;
		if (!run_barrier(&m, alone))
			return;
	}
	// after a meeting all have read where it began
	if (begin == 0)
		met[1] = m.arrivals;
}
