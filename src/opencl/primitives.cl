// SPDX-License-Identifier: MIT
// primitives.cl -- sorts keys and computes prefix sums, with two launches per pass.
//
// In the first launch, each work-group counts (or sums) its part of the items into a row of a table. In the second, it
// adds up the rows of earlier parts and writes its items to their places. Groups may run in any order. A third launch
// to scan the table would take longer than these repeated reads: the table is small and cached. In the persistent
// kernel a barrier replaces the second launch. Pools are passed as the buffer of their kind and an offset in bytes.
#include "opencl/group_sizes.h"
#include "pools/pools.h"

#define SORT_WORDS (PRIMITIVE_GROUP / 32)

INLINE uint item_count(Run run, __global const int* counters)
{
	return (uint)max(0, run.count < 0 ? run.end : min(run.end, counters[run.count]));
}

// Returns the number of items per part, a multiple of `grain`, such that n items have at most `groups` parts.
INLINE uint part_size(uint n, uint groups, uint grain)
{
	uint grains = (n + grain - 1) / grain;
	return max(1u, (grains + groups - 1) / groups) * grain;
}

// Returns the sum of x over the earlier work-items of the group. Sets sum[PRIMITIVE_GROUP - 1] to the sum over all.
INLINE_MEET uint group_scan(LOCAL uint* sum, uint x)
{
	uint t = (uint)get_local_id(0);
	uint all = x;
	sum[t] = all;
	barrier(CLK_LOCAL_MEM_FENCE);
	for (uint d = 1; d < PRIMITIVE_GROUP; d *= 2)
	{
		uint before = t >= d ? sum[t - d] : 0;
		barrier(CLK_LOCAL_MEM_FENCE);
		all += before;
		sum[t] = all;
		barrier(CLK_LOCAL_MEM_FENCE);
	}
	return all - x;
}

typedef struct __attribute__((aligned(8))) // local memory of a work-group; sort_few uses `member` for 64-bit keys
{
	uint sum[PRIMITIVE_GROUP];
	uint member[2][SORT_WORDS][SORT_DIGITS];
	uint place[SORT_WORDS][SORT_DIGITS];
} SortMemory;

INLINE_MEET void sort_count_part(__global const Word64* key, uint n, __global uint* table, uint block, int shift,
                                 uint mask, LOCAL uint* count)
{
	uint t = (uint)get_local_id(0);
	uint part = part_size(n, SORT_BLOCKS, SORT_GRAIN);
	uint begin = min(n, block * part), end = min(n, begin + part);
	if (begin >= end)
		return;

	count[t] = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	for (uint i = begin + t; i < end; i += PRIMITIVE_GROUP)
		atomic_inc(&count[(uint)(key[i] >> shift) & mask]);
	barrier(CLK_LOCAL_MEM_FENCE);
	table[block * SORT_DIGITS + t] = count[t];
}

// Writes the keys of a part to their places, sorted stably by one digit. Every 32 work-items have a bit mask per digit.
// A work-item sets its bit in the mask of its digit; the number of lower bits that are set is the rank of its key among
// keys with this digit. Work-item t keeps the next place of digit t.
INLINE_MEET void sort_place_part(__global const Word64* key, __global Word64* key_other, uint n,
                                 __global const uint* table, uint block, int shift, uint mask, LOCAL SortMemory* bench)
{
	uint t = (uint)get_local_id(0);
	uint part = part_size(n, SORT_BLOCKS, SORT_GRAIN);
	uint begin = min(n, block * part), end = min(n, begin + part);
	if (begin >= end)
		return;

	// first place of this part for digit t: after all keys with smaller digits, and keys with digit t in earlier parts
	uint before = 0, total = 0, blocks = (n + part - 1) / part;
	for (uint k = 0; k < blocks; ++k)
	{
		uint count = table[k * SORT_DIGITS + t];
		before += k < block ? count : 0;
		total += count;
	}
	uint next_place = before + group_scan(bench->sum, total);

	for (uint w = 0; w < SORT_WORDS; ++w)
		bench->member[0][w][t] = 0;
	barrier(CLK_LOCAL_MEM_FENCE);
	uint word = t / 32, bit = 1u << (t % 32), side = 0;
	Word64 next = begin + t < end ? key[begin + t] : 0;
	for (uint first = begin; first < end; first += PRIMITIVE_GROUP)
	{
		Word64 mine = next;
		bool live = first + t < end;
		uint digit = (uint)(mine >> shift) & mask;
		if (live)
			atomic_or(&bench->member[side][word][digit], bit);
		if (first + PRIMITIVE_GROUP + t < end)
			next = key[first + PRIMITIVE_GROUP + t];
		barrier(CLK_LOCAL_MEM_FENCE);
		for (uint w = 0; w < SORT_WORDS; ++w)
		{
			bench->place[w][t] = next_place;
			next_place += popcount(bench->member[side][w][t]);
			bench->member[side ^ 1][w][t] = 0;
		}
		barrier(CLK_LOCAL_MEM_FENCE);
		if (live)
			key_other[bench->place[word][digit] + popcount(bench->member[side][word][digit] & (bit - 1))] = mine;
		side ^= 1;
	}
	barrier(CLK_LOCAL_MEM_FENCE);
}

// Sorts up to SORT_FEW keys stably by bits `from` to `end` - 1. The place of a key is the number of smaller keys plus
// the number of equal keys before it. Each work-group has all keys in local memory; SORT_TEAM work-items count for one
// key.
INLINE_MEET void sort_few(__global const Word64* key, __global Word64* key_other, uint n, int from, int end,
                          LOCAL SortMemory* bench)
{
	const uint teams = PRIMITIVE_GROUP / SORT_TEAM;
	uint t = (uint)get_local_id(0), team = t / SORT_TEAM, member = t % SORT_TEAM;
	LOCAL Word64* keys = (LOCAL Word64*)bench->member;
	int left = 64 - end;
	for (uint i = t; i < n; i += PRIMITIVE_GROUP)
		keys[i] = key[i] << left >> (left + from);
	for (uint first = (uint)get_group_id(0) * teams; first < n; first += (uint)get_num_groups(0) * teams)
	{
		uint k = first + team, before = 0;
		if (t < teams)
			bench->sum[t] = 0;
		barrier(CLK_LOCAL_MEM_FENCE);
		if (k < n)
		{
			Word64 mine = keys[k];
			for (uint j = member; j < n; j += SORT_TEAM)
				before += keys[j] < mine || (keys[j] == mine && j < k);
			atomic_add(&bench->sum[team], before);
		}
		barrier(CLK_LOCAL_MEM_FENCE);
		if (member == 0 && k < n)
			key_other[bench->sum[team]] = key[k];
		barrier(CLK_LOCAL_MEM_FENCE);
	}
}

INLINE_MEET void scan_sum_part(__global const int* scan, uint n, __global uint* table, uint block, LOCAL uint* sum)
{
	uint t = (uint)get_local_id(0);
	uint part = part_size(n, SCAN_BLOCKS, SCAN_GRAIN);
	uint begin = min(n, block * part), end = min(n, begin + part);
	if (begin >= end)
		return;

	uint mine = 0;
	for (uint i = begin + t; i < end; i += PRIMITIVE_GROUP)
		mine += (uint)scan[i];
	group_scan(sum, mine);
	if (t == 0)
		table[block] = sum[PRIMITIVE_GROUP - 1];
	barrier(CLK_LOCAL_MEM_FENCE);
}

// Replaces each item of a part by the sum of all items before it.
INLINE_MEET void scan_place_part(__global int* scan, uint n, __global const uint* table, uint block, LOCAL uint* sum)
{
	uint t = (uint)get_local_id(0);
	uint part = part_size(n, SCAN_BLOCKS, SCAN_GRAIN);
	uint begin = min(n, block * part), end = min(n, begin + part);
	if (begin >= end)
		return;

	uint earlier = 0;
	for (uint k = t; k < block; k += PRIMITIVE_GROUP)
		earlier += table[k];
	group_scan(sum, earlier);
	uint base = sum[PRIMITIVE_GROUP - 1];
	barrier(CLK_LOCAL_MEM_FENCE);

	for (uint first = begin; first < end; first += SCAN_GRAIN)
	{
		uint i = first + t * SCAN_ITEMS, mine = 0;
		uint item[SCAN_ITEMS];
		for (uint k = 0; k < SCAN_ITEMS; ++k)
		{
			item[k] = i + k < end ? (uint)scan[i + k] : 0;
			mine += item[k];
		}
		uint running = base + group_scan(sum, mine);
		for (uint k = 0; k < SCAN_ITEMS; ++k)
		{
			if (i + k < end)
				scan[i + k] = (int)running;
			running += item[k];
		}
		base += sum[PRIMITIVE_GROUP - 1];
		barrier(CLK_LOCAL_MEM_FENCE);
	}
}

#define PRIMITIVE __kernel __attribute__((reqd_work_group_size(PRIMITIVE_GROUP, 1, 1))) void

PRIMITIVE sort_count(__global uchar* keys, __global const int* counters, __global uint* table, Run run, ulong from,
                     int shift, uint mask)
{
	__local uint count[SORT_DIGITS];
	sort_count_part((__global const Word64*)(keys + from), item_count(run, counters), table, (uint)get_group_id(0), shift,
	                mask, count);
}

PRIMITIVE sort_place(__global uchar* keys, __global const int* counters, __global const uint* table, Run run, ulong from,
                     ulong to, int shift, uint mask)
{
	__local SortMemory bench;
	sort_place_part((__global const Word64*)(keys + from), (__global Word64*)(keys + to), item_count(run, counters),
	                table, (uint)get_group_id(0), shift, mask, &bench);
}

// Copies the sorted keys to the pool `key` after an odd number of passes.
__kernel void sort_return(__global uchar* keys, __global const int* counters, Run run, ulong from, ulong to)
{
	__global const Word64* key_other = (__global const Word64*)(keys + from);
	__global Word64* key = (__global Word64*)(keys + to);
	uint n = item_count(run, counters);
	for (uint i = (uint)get_global_id(0); i < n; i += (uint)get_global_size(0))
		key[i] = key_other[i];
}

PRIMITIVE scan_sum(__global uchar* contacts, __global const int* counters, __global uint* table, Run run, ulong at)
{
	__local uint sum[PRIMITIVE_GROUP];
	scan_sum_part((__global const int*)(contacts + at), item_count(run, counters), table, (uint)get_group_id(0), sum);
}

PRIMITIVE scan_place(__global uchar* contacts, __global const int* counters, __global const uint* table, Run run,
                     ulong at)
{
	__local uint sum[PRIMITIVE_GROUP];
	scan_place_part((__global int*)(contacts + at), item_count(run, counters), table, (uint)get_group_id(0), sum);
}
