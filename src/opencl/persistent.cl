// SPDX-License-Identifier: MIT
// persistent.cl -- executes many runs in one launch, with device-wide barriers between runs.
//
// A barrier takes a quarter of the time of a launch. It needs all work-groups resident at once, which OpenCL does not
// guarantee. So the host tests it when it opens a device (PERSISTENT_PROBE), and every spin-wait has a limit.
#include "opencl/group_sizes.h"
#include "pools/pools.h"

enum
{
#define X(name, width, box) KERNEL_##name,
#include "stages/kernels.def"
#undef X
	KERNEL_COUNT,
	PRIMITIVE_SORT = KERNEL_COUNT,
	PRIMITIVE_SCAN
};

typedef struct // device-wide barrier
{
	volatile __global int* arrived; // counter of arrivals of work-groups at barriers; never reset between launches
	volatile __global int* fault;
	volatile LOCAL int* healthy;
	int arrivals; // value of *arrived after the last barrier
	int spins;    // maximum number of reads of a spin-wait
} DeviceBarrier;

// Waits until all work-groups have arrived. Returns false if a spin-wait of any work-group has reached its limit.
INLINE_MEET bool device_barrier(DeviceBarrier* b)
{
	b->arrivals = (int)((uint)b->arrivals + (uint)get_num_groups(0));
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	if (get_local_id(0) == 0)
	{
		DEVICE_FENCE();
		atomic_inc(b->arrived);
		int spins = b->spins;
		while ((int)((uint)read_shared(b->arrived) - (uint)b->arrivals) < 0 && spins > 0)
			--spins;
		if (spins <= 0)
			*b->fault = FAULT_TIMEOUT;
		DEVICE_FENCE();
		*b->healthy = *b->fault == 0;
	}
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return *b->healthy;
}

// Waits in the first work-group until all others have arrived at the next barrier. Returns false like device_barrier.
INLINE_MEET bool device_barrier_await(const DeviceBarrier* b)
{
	if (get_local_id(0) == 0)
	{
		int spins = b->spins;
		uint others = (uint)b->arrivals + (uint)get_num_groups(0) - 1u;
		while ((int)((uint)read_shared(b->arrived) - others) < 0 && spins > 0)
			--spins;
		if (spins <= 0)
			*b->fault = FAULT_TIMEOUT;
		DEVICE_FENCE();
		*b->healthy = *b->fault == 0;
	}
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return *b->healthy;
}

// Executes run k of the probe. Each work-item writes k for a work-item of another group, and checks that a work-item of
// a third group wrote k - 1 for it in the previous run. The reads are not volatile, and their addresses repeat, so a
// stale cache is detected.
INLINE void probe(__global int* probes, volatile __global int* fault, int k)
{
	int n = (int)get_global_size(0), i = (int)get_global_id(0), group = (int)get_local_size(0);
	__global int* now = probes + (k & 1) * n;
	__global const int* last = probes + (~k & 1) * n;
	if (k > 0 && last[(i + group) % n] != k - 1)
		*fault = FAULT_STALE;
	now[(i + 2 * group) % n] = k;
}

// Waits at the device-wide barrier, or at a barrier of this group if `alone`. Returns false if a spin-wait timed out.
INLINE_MEET bool run_barrier(DeviceBarrier* b, bool alone)
{
	if (!alone)
		return device_barrier(b);
	barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
	return true;
}

// Sorts like primitives.c, with all work-groups, or with one if `alone`. Returns false if a spin-wait timed out.
INLINE_MEET bool persistent_sort(const Pools* p, Run run, __global uint* table, LOCAL SortMemory* bench,
                                 DeviceBarrier* b, bool alone)
{
	uint n = item_count(run, (__global const int*)p->counters), part = part_size(n, SORT_BLOCKS, SORT_GRAIN);
	uint first = (uint)get_group_id(0), groups = alone ? 1u : (uint)get_num_groups(0), blocks = (n + part - 1) / part;
	int from = RUN_LOW(run.argument), end = RUN_HIGH(run.argument);
	__global Word64 *key = p->key, *other = p->key_other;
	if (n <= SORT_FEW && !alone)
	{
		// sort_few takes one barrier; the radix sort takes two barriers per pass, and up to eight passes
		sort_few(key, other, n, from, end, bench);
		if (!device_barrier(b))
			return false;
		key = other;
		end = from;
	}
	for (int shift = from; shift < end; shift += SORT_DIGIT_BITS)
	{
		uint mask = (1u << min(SORT_DIGIT_BITS, end - shift)) - 1;
		for (uint block = first; block < blocks; block += groups)
			sort_count_part(key, n, table, block, shift, mask, bench->sum);
		if (!run_barrier(b, alone))
			return false;
		for (uint block = first; block < blocks; block += groups)
			sort_place_part(key, other, n, table, block, shift, mask, bench);
		if (!run_barrier(b, alone))
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

INLINE_MEET bool persistent_scan(const Pools* p, Run run, __global uint* table, LOCAL uint* sum, DeviceBarrier* b)
{
	uint n = item_count(run, (__global const int*)p->counters);
	uint first = (uint)get_group_id(0), groups = (uint)get_num_groups(0);
	for (uint block = first; block < SCAN_BLOCKS; block += groups)
		scan_sum_part(p->scan, n, table, block, sum);
	if (!device_barrier(b))
		return false;
	for (uint block = first; block < SCAN_BLOCKS; block += groups)
		scan_place_part(p->scan, n, table, block, sum);
	return true;
}

// Cases of a switch: execute a run, one item per work-item. Kernels of groups and rare kernels are launched instead.
#define CASE_ONE(name, p)                                \
	case KERNEL_##name:                                   \
		for (int i = run.begin + from; i < end; i += by) \
			name##_item(p, i);                           \
		break;
#define CASE_WIDE(name, p) CASE_ONE(name, p)
#define CASE_ALONE(name, p)
#define CASE_WIDE_ALONE(name, p)
#define CASE_GROUP(name, p)
#define CASE_TEAM(name, p)

// Returns the end of a run, which its counter may lower. The counter may change until the next barrier.
INLINE int run_end(Run run, const Pools* p)
{
	return run.count < 0 ? run.end : min(run.end, ((volatile __global int*)p->counters)[run.count]);
}

// Returns whether the first work-group alone executes a run faster than all groups with a device-wide barrier.
INLINE bool takes_one_group(Run run, int end)
{
	int most = run.kernel_id == PRIMITIVE_SORT ? SORT_GRAIN : run.kernel_id < KERNEL_COUNT && run.kernel_id >= 0 ? PERSISTENT_GROUP : 0;
	return end - run.begin <= most;
}

// Returns run i of the list, or a run without items if the list is shorter.
INLINE Run run_at(__global const int* list, int count, int i)
{
	Run run = {0, 0, 0, -1, 0};
	if (i < count)
		run = ((__global const Run*)(list + PERSISTENT_HEADER))[i];
	return run;
}

// Finds the first run with items, from index `next` on; copies it to *chosen and returns its index. Returns `count` if
// there is none. mine: the run that this work-item holds.
INLINE_MEET int next_run(const Pools* pools, Run mine, int next, int count, volatile LOCAL int* found,
                         LOCAL Run* chosen)
{
	int lane = (int)get_local_id(0);
	if (lane == 0)
		*found = count;
	barrier(CLK_LOCAL_MEM_FENCE);
	if (lane >= next && mine.begin < run_end(mine, pools))
		atomic_min(found, lane);
	barrier(CLK_LOCAL_MEM_FENCE);
	if (*found == lane)
		*chosen = mine;
	barrier(CLK_LOCAL_MEM_FENCE);
	return *found;
}

// Executes a primitive, or a run of the barrier test (function probe). Returns false if a spin-wait reached its limit.
INLINE_MEET bool run_primitive(const Pools* p, Run run, __global uint* table, __global int* probes,
                               LOCAL SortMemory* bench, DeviceBarrier* b, bool alone)
{
	if (run.kernel_id == PRIMITIVE_SORT)
		return persistent_sort(p, run, table, bench, b, alone);
	if (run.kernel_id == PRIMITIVE_SCAN)
		return persistent_scan(p, run, table, bench->sum, b);
	if (run.kernel_id == PERSISTENT_PROBE)
		probe(probes, b->fault, run.argument);
	return true;
}

// fails to compile if the local memory of this kernel, the largest besides the tiles, exceeds LOCAL_LEAST
typedef char persistent_fits[sizeof(SortMemory) + sizeof(Run) + 8 <= LOCAL_LEAST ? 1 : -1];

// Executes the runs of a list. The list begins with PERSISTENT_HEADER ints. [0]: number of arrivals at barriers; [1]:
// its value after the last launch; [2]: first run that all groups execute after runs of the first group alone. Then
// follow `count` runs, at most one for each work-item of a group. A run may change the ends of later runs, so each
// work-item holds one run and reads its end after every barrier: all ends in one memory access, and runs without items
// take no time. The first group executes consecutive short runs alone. Before these runs it waits until the other
// groups have arrived at the next device-wide barrier, and so have read the ends that these runs may change.
__kernel void persistent(POOL_ARGUMENTS Step step, __global int* list, int count, __global uint* table,
                         __global int* probes, int spins)
{
	volatile __local int healthy, found;
	__local Run chosen;
	__local SortMemory bench;
	Pools pools = {POOL_NAMES step, 0};
	int lane = (int)get_local_id(0), begin = (int)get_global_id(0), stride = (int)get_global_size(0);
	Run mine = run_at(list, count, lane);
	volatile __global int* header = list;
	DeviceBarrier b = {header, &pools.counters->fault, &healthy, header[1], spins};
	bool single = get_num_groups(0) == 1, alone = single;
	for (int next = 0;;)
	{
		next = next_run(&pools, mine, next, count, &found, &chosen);
		Run run = chosen;
		int end = next < count ? run_end(run, &pools) : 0;
		bool shares = next == count || !takes_one_group(run, end);
		if (alone && shares && !single)
		{
			if (lane == 0)
				header[2] = next;
			alone = false;
			if (!device_barrier(&b))
				return;
		}
		if (next == count)
			break;
		if (!alone && !shares)
		{
			alone = get_group_id(0) == 0;
			if (!(alone ? device_barrier_await(&b) : device_barrier(&b)))
				return;
			if (!alone)
			{
				next = header[2];
				continue;
			}
		}
		++next;
		int from = alone ? lane : begin, by = alone ? (int)get_local_size(0) : stride;
		pools.argument = run.argument;
		switch (run.kernel_id)
		{
#define X(name, width, box) CASE_##width(name, &pools)
#include "stages/kernels.def"
#undef X
		default:
			if (!run_primitive(&pools, run, table, probes, &bench, &b, alone))
				return;
		}
		if (!alone && next == count)
			break;
		if (!run_barrier(&b, alone))
			return;
	}
	// every work-group has read header[1] before the last barrier
	if (begin == 0)
		header[1] = b.arrivals;
}
