// SPDX-License-Identifier: MIT
// test_primitives.c -- checks sort and scan of every backend against the simplest implementations.
//
// Formulas. Sort: the output is a permutation of the input, in ascending order of the bits in the given range; keys
// that are equal in this range keep their order. Scan: out[i] = in[0] + ... + in[i - 1].
#include "backend/backend.h"
#include "support/each_backend.h"
#include "tools/common/random_numbers.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CAPACITY (1 << 20)

static int room_of(Per per) { return per == PER_KEY || per == PER_CONTACT ? CAPACITY : 1; }

static int open_all_backends(void** state)
{
	(void)state;
	open_backends(true, room_of);
	return 0;
}

typedef enum
{
	RANDOM,
	FEW,   // few different keys: each 16-bit digit has one of four values
	EQUAL, // all keys are equal
	RISING,
	FALLING,
	EXTREMES, // each key has all 64 bits set, or no bit
	INPUTS
} Input;

static uint64_t make_key(Input input, int i, int count, uint64_t* seed)
{
	uint64_t word = random_word(seed);
	switch (input)
	{
	case FEW:
		return word & 0x0003000300030003u;
	case EQUAL:
		return 0x5555555555555555u;
	case RISING:
		return (uint64_t)i << 20 | (uint64_t)i;
	case FALLING:
		return (uint64_t)(count - i) << 20 | (uint64_t)i;
	case EXTREMES:
		return word & 1 ? UINT64_MAX : 0;
	default:
		return word;
	}
}

// Sorts keys by one bit after the other, from first_bit to end_bit - 1. The code under test uses wider digits.
static void reference_sort(uint64_t* keys, uint64_t* other, int count, int first_bit, int end_bit)
{
	for (int bit = first_bit; bit < end_bit; ++bit)
	{
		int place = 0;
		for (uint64_t value = 0; value < 2; ++value)
			for (int i = 0; i < count; ++i)
				if ((keys[i] >> bit & 1) == value)
					other[place++] = keys[i];
		memcpy(keys, other, (size_t)count * sizeof *keys);
	}
}

// Compares arrays of items. At the first difference the test fails with the name of the backend and the index.
static void check_equal(const Backend* b, const char* what, const void* got, const void* expected, size_t item,
                        int count)
{
	for (int i = 0; i < count; ++i)
		if (memcmp((const char*)got + item * (size_t)i, (const char*)expected + item * (size_t)i, item) != 0)
			fail_msg("%s: %s: item %d of %d is wrong", b->name, what, i, count);
}

static void run_on(Backend* b, Run run, int bound)
{
	Counters counters = {0};
	counters.contacts = bound;
	Step step = {0};
	assert_int_equal(b->f->write(b, POOL_counters, 0, 1, &counters), SCREE_OK);
	assert_int_equal(b->f->run(b, &step, &run, 1), SCREE_OK);
}

// Sorts the first `end` keys on every backend and checks the result. With use_bound, a counter limits the sort to the
// first `bound` keys.
static void check_sort(Input input, int end, int bound, bool use_bound, int first_bit, int end_bit, uint64_t seed)
{
	static uint64_t keys[CAPACITY], expected[CAPACITY], got[CAPACITY];
	int count = use_bound && bound < end ? bound : end;
	int whole = end + 100 < CAPACITY ? end + 100 : CAPACITY; // 100 more keys, if there is room; they must not change
	for (int i = 0; i < whole; ++i)
		keys[i] = make_key(input, i, end, &seed);
	memcpy(expected, keys, (size_t)whole * sizeof *keys);
	reference_sort(expected, got, count, first_bit, end_bit);

	char what[128];
	snprintf(what, sizeof what, "sort of input %d, %d keys, bound %d, bits %d to %d", (int)input, end,
	         use_bound ? bound : -1, first_bit, end_bit);
	Run run = {PRIMITIVE_SORT, 0, end, use_bound ? COUNT(contacts) : NO_COUNT, RUN_PAIR(first_bit, end_bit)};
	for (int k = 0; k < backend_count; ++k)
	{
		Backend* b = backends[k];
		assert_int_equal(b->f->write(b, POOL_key, 0, whole, keys), SCREE_OK);
		run_on(b, run, bound);
		assert_int_equal(b->f->read(b, POOL_key, 0, whole, got), SCREE_OK);
		check_equal(b, what, got, expected, sizeof *got, whole);
	}
}

static void check_scan(int end, int bound, bool use_bound, int range, uint64_t seed)
{
	static int items[CAPACITY], expected[CAPACITY], got[CAPACITY];
	int count = use_bound && bound < end ? bound : end;
	int whole = end + 100 < CAPACITY ? end + 100 : CAPACITY;
	int sum = 0;
	for (int i = 0; i < whole; ++i)
	{
		items[i] = expected[i] = (int)(random_word(&seed) % (uint64_t)range);
		if (i < count)
			expected[i] = sum;
		sum += i < count ? items[i] : 0;
	}

	char what[128];
	snprintf(what, sizeof what, "scan of %d items, bound %d", end, use_bound ? bound : -1);
	Run run = {PRIMITIVE_SCAN, 0, end, use_bound ? COUNT(contacts) : NO_COUNT, 0};
	for (int k = 0; k < backend_count; ++k)
	{
		Backend* b = backends[k];
		assert_int_equal(b->f->write(b, POOL_scan, 0, whole, items), SCREE_OK);
		run_on(b, run, bound);
		assert_int_equal(b->f->read(b, POOL_scan, 0, whole, got), SCREE_OK);
		check_equal(b, what, got, expected, sizeof *got, whole);
	}
}

static const int sizes[] = {1,   2,   3,    31,   32,   33,   255,   256,   257,    511,
                            512, 513, 1000, 4095, 4096, 4097, 20000, 65536, 131073, 300001};
#define SIZES (int)(sizeof sizes / sizeof *sizes)

static void test_sort_sizes(void** state)
{
	(void)state;
	for (int i = 0; i < SIZES; ++i)
		check_sort(RANDOM, sizes[i], 0, false, 0, 32, (uint64_t)i + 1);
}

static void test_sort_inputs(void** state)
{
	(void)state;
	for (int input = 0; input < INPUTS; ++input)
		for (int i = 0; i < SIZES; i += 3)
			check_sort((Input)input, sizes[i], 0, false, 0, 64, 7);
}

// Checks that the result is in the pool `key` for each range of bits, and so for each number of passes of the sort.
static void test_sort_bits(void** state)
{
	(void)state;
	for (int first = 0; first < 64; first += 7)
		for (int end = first; end <= 64; end += 3)
			check_sort(RANDOM, 3000, 0, false, first, end, 11);
}

// Keys that are equal in the sorted range of bits must keep their order. Their other bits differ, so a changed order is
// found.
static void test_sort_is_stable(void** state)
{
	(void)state;
	check_sort(FALLING, 100000, 0, false, 24, 28, 13);
	check_sort(RANDOM, 100000, 0, false, 60, 64, 13);
	check_sort(RANDOM, 100000, 0, false, 33, 34, 13);
}

static void test_sort_counts_from_device(void** state)
{
	(void)state;
	const int bounds[] = {0, 1, 2, 255, 256, 257, 5000, 131072, 299999, 300000, 300001, 2000000};
	for (size_t i = 0; i < sizeof bounds / sizeof *bounds; ++i)
		check_sort(RANDOM, 300000, bounds[i], true, 0, i % 2 ? 32 : 24, 17 + i);
}

static void test_sort_fills_the_pool(void** state)
{
	(void)state;
	check_sort(RANDOM, CAPACITY, 0, false, 0, 40, 19);
}

static void test_scan_sizes(void** state)
{
	(void)state;
	for (int i = 0; i < SIZES; ++i)
		check_scan(sizes[i], 0, false, i % 2 ? 2 : 1000, (uint64_t)i + 1);
	check_scan(CAPACITY, 0, false, 2, 23);
}

static void test_scan_counts_from_device(void** state)
{
	(void)state;
	const int bounds[] = {0, 1, 2, 1023, 1024, 1025, 5000, 131072, 899999, 900000, 900001, 2000000};
	for (size_t i = 0; i < sizeof bounds / sizeof *bounds; ++i)
		check_scan(900000, bounds[i], true, 2, 29 + i);
}

// Reads blocks of several sizes from a pool. One block is as long as the counters of a device, but its bytes must not
// count as faults of the device.
static void reads_have_any_size(void** state)
{
	(void)state;
	enum
	{
		WORDS = 1024
	};
	static uint32_t words[WORDS], got[WORDS];
	for (int k = 0; k < WORDS; ++k)
		words[k] = 0x01010101u * (uint32_t)(k % 255 + 1);
	int counts[] = {1, (int)(sizeof(Counters) / sizeof(uint32_t)), WORDS - 1, WORDS};
	for (int n = 0; n < backend_count; ++n)
		for (int k = 0; k < 4; ++k)
		{
			Backend* b = backends[n];
			assert_int_equal(b->f->write(b, POOL_scan, 0, counts[k], words), SCREE_OK);
			memset(got, 0, sizeof got);
			assert_int_equal(b->f->read(b, POOL_scan, 0, counts[k], got), SCREE_OK);
			assert_memory_equal(got, words, (size_t)counts[k] * sizeof *words);
		}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(reads_have_any_size),
	    cmocka_unit_test(test_sort_sizes),
	    cmocka_unit_test(test_sort_inputs),
	    cmocka_unit_test(test_sort_bits),
	    cmocka_unit_test(test_sort_is_stable),
	    cmocka_unit_test(test_sort_counts_from_device),
	    cmocka_unit_test(test_sort_fills_the_pool),
	    cmocka_unit_test(test_scan_sizes),
	    cmocka_unit_test(test_scan_counts_from_device),
	};
	return cmocka_run_group_tests(tests, open_all_backends, close_backends);
}
