// SPDX-License-Identifier: MIT
// primitives.c -- sort and scan, by all workers together or by one alone.
#include "cpu/primitives.h"
#include <string.h>

// keys that are inserted rather than sorted by digits: with 64, both take about as long
#define FEW_KEYS 64

static void meet(Threads* threads, int workers)
{
	if (workers > 1)
		threads_barrier(threads);
}

static void count_digits(int counts[RADIX], const uint64_t* keys, int begin, int end, int shift, uint64_t mask)
{
	memset(counts, 0, RADIX * sizeof(int));
	for (int i = begin; i < end; ++i)
		++counts[keys[i] >> shift & mask];
}

// The place of this worker's first key of each digit: behind all smaller digits, and behind the equal digits of the
// workers before it, so the sort is stable. False if all keys have the same digit, so that nothing has to move.
static bool place_digits(int place[RADIX], const Shared* shared, int worker, int workers, int count)
{
	int sum = 0;
	for (int digit = 0; digit < RADIX; ++digit)
	{
		int before = sum;
		for (int w = 0; w < workers; ++w)
		{
			if (w == worker)
				place[digit] = sum;
			sum += shared->counts[w][digit];
		}
		if (sum - before == count)
			return false;
	}
	return true;
}

// Insertion sort: of few keys, a look at every digit takes longer than all comparisons.
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

// Radix sort from the lowest digit up. Peter McIlroy, Keith Bostic, Doug McIlroy, Engineering Radix Sort, 1993; split over
// workers as in Marco Zagha, Guy Blelloch, Radix Sort for Vector Multiprocessors, 1991.
void sort_keys(Shared* shared, Threads* threads, int worker, int workers, uint64_t* keys, uint64_t* other, int count,
               int low, int high)
{
	if (workers == 1 && count <= FEW_KEYS)
	{
		if (low < high)
			insert_keys(keys, count, low, high);
		return;
	}

	int begin = split(count, worker, workers), end = split(count, worker + 1, workers);
	uint64_t *from = keys, *to = other;

	for (int shift = low; shift < high; shift += RADIX_BITS)
	{
		int bits = high - shift < RADIX_BITS ? high - shift : RADIX_BITS;
		uint64_t mask = ((uint64_t)1 << bits) - 1;
		count_digits(shared->counts[worker], from, begin, end, shift, mask);
		meet(threads, workers);

		int place[RADIX];
		bool moves = place_digits(place, shared, worker, workers, count);
		if (moves)
		{
			for (int i = begin; i < end; ++i)
				to[place[from[i] >> shift & mask]++] = from[i];
			uint64_t* swap = from;
			from = to;
			to = swap;
		}
		meet(threads, workers);
	}

	if (from != keys)
		memcpy(keys + begin, from + begin, (size_t)(end - begin) * sizeof(uint64_t));
}

void scan_values(Shared* shared, Threads* threads, int worker, int workers, int* values, int count)
{
	int begin = split(count, worker, workers), end = split(count, worker + 1, workers);
	int sum = 0;
	if (workers > 1)
	{
		for (int i = begin; i < end; ++i)
			sum += values[i];
		shared->sums[worker] = sum;
		meet(threads, workers);
		sum = 0;
		for (int w = 0; w < worker; ++w)
			sum += shared->sums[w];
	}

	for (int i = begin; i < end; ++i)
	{
		int value = values[i];
		values[i] = sum;
		sum += value;
	}
}
