// SPDX-License-Identifier: MIT
// primitives.c -- sorts keys and computes prefix sums, as jobs whose blocks are shares of the items.
#include "cpu/primitives.h"
#include <string.h>

#define FEW_KEYS 64 // up to this number, keys are sorted by insertion, which takes as long as a radix sort of 64 keys

static void count_digits(int counts[RADIX], const uint64_t* keys, int begin, int end, int shift, uint64_t mask)
{
	memset(counts, 0, RADIX * sizeof(int));
	for (int i = begin; i < end; ++i)
		++counts[keys[i] >> shift & mask];
}

// Computes the place of a block's first key of each digit: behind all smaller digits, and behind equal digits of
// earlier blocks, so that the sort is stable. Returns false if the digits of all keys are equal, so that no key moves.
static bool place_digits(int place[RADIX], const Shared* shared, int block, int blocks, int count)
{
	int sum = 0;
	for (int digit = 0; digit < RADIX; ++digit)
	{
		int before = sum;
		for (int b = 0; b < blocks; ++b)
		{
			if (b == block)
				place[digit] = sum;
			sum += shared->counts[b][digit];
		}
		if (sum - before == count)
			return false;
	}
	return true;
}

static void insert_keys(uint64_t* keys, int count, int low, int high)
{
	uint64_t mask = ((uint64_t)2 << (high - low - 1)) - 1;
	for (int i = 1; i < count; ++i)
	{
		uint64_t key = keys[i], digits = key >> low & mask;
		int place = i;
		for (; place > 0 && (keys[place - 1] >> low & mask) > digits; --place)
			keys[place] = keys[place - 1];
		keys[place] = key;
	}
}

static void count_block(void* context, int block, int blocks)
{
	Shared* s = context;
	count_digits(s->counts[block], s->from, split(s->count, block, blocks), split(s->count, block + 1, blocks),
	             s->shift, s->mask);
}

static void place_block(void* context, int block, int blocks)
{
	Shared* s = context;
	int place[RADIX], end = split(s->count, block + 1, blocks);
	bool moves = place_digits(place, s, block, blocks, s->count);
	for (int i = split(s->count, block, blocks); i < end && moves; ++i)
		s->to[place[s->from[i] >> s->shift & s->mask]++] = s->from[i];
	if (block == 0)
		s->moves = moves;
}

static void copy_block(void* context, int block, int blocks)
{
	Shared* s = context;
	int begin = split(s->count, block, blocks), end = split(s->count, block + 1, blocks);
	memcpy(s->to + begin, s->from + begin, (size_t)(end - begin) * sizeof(uint64_t));
}

// Radix sort that begins with the lowest digit. Peter McIlroy, Keith Bostic, Doug McIlroy, Engineering Radix Sort,
// 1993; in blocks as in Marco Zagha, Guy Blelloch, Radix Sort for Vector Multiprocessors, 1991.
void sort_keys(Shared* s, Threads* threads, int blocks, uint64_t* keys, uint64_t* other, int count, int low, int high)
{
	if (blocks == 1 && count <= FEW_KEYS)
	{
		if (low < high)
			insert_keys(keys, count, low, high);
		return;
	}
	s->from = keys;
	s->to = other;
	s->count = count;
	for (s->shift = low; s->shift < high; s->shift += RADIX_BITS)
	{
		int bits = high - s->shift < RADIX_BITS ? high - s->shift : RADIX_BITS;
		s->mask = ((uint64_t)1 << bits) - 1;
		threads_run(threads, count_block, s, blocks);
		threads_run(threads, place_block, s, blocks);
		if (s->moves)
		{
			uint64_t* swap = s->from;
			s->from = s->to;
			s->to = swap;
		}
	}
	if (s->from != keys)
		threads_run(threads, copy_block, s, blocks);
}

static void sum_block(void* context, int block, int blocks)
{
	Shared* s = context;
	int end = split(s->count, block + 1, blocks), sum = 0;
	for (int i = split(s->count, block, blocks); i < end; ++i)
		sum += s->values[i];
	s->sums[block] = sum;
}

static void scan_block(void* context, int block, int blocks)
{
	Shared* s = context;
	int end = split(s->count, block + 1, blocks), sum = 0;
	for (int b = 0; b < block; ++b)
		sum += s->sums[b];
	for (int i = split(s->count, block, blocks); i < end; ++i)
	{
		int value = s->values[i];
		s->values[i] = sum;
		sum += value;
	}
}

void scan_values(Shared* s, Threads* threads, int blocks, int* values, int count)
{
	s->values = values;
	s->count = count;
	if (blocks > 1)
		threads_run(threads, sum_block, s, blocks);
	threads_run(threads, scan_block, s, blocks);
}
