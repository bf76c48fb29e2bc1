// SPDX-License-Identifier: MIT
// self_test.c -- finds float operations that this build computes wrongly, by hashes of stored results.
#include "cpu/self_test.h"
#include "backend/backend.h"
#include "dialect/dialect.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

static const struct
{
	Word hash;
	const char *fault, *remedy;
} tests[] = {
#define X(name, hash, fault, remedy) {hash, fault, remedy},
#include "cpu/self_test.def"
#undef X
};

static const struct
{
	SelfTestFunction* function;
	int lanes; // the processor must have them
	const char* name;
} codes[] = {
    {self_test_host, 1, "the host"},
    {self_test_lanes1, 1, "1 lane"},
#if SCREE_LANES & 4
    {self_test_lanes4, 4, "4 lanes"},
#endif
#if SCREE_LANES >= 8
    {self_test_scalar_avx2, 8, "1 lane of AVX2"},
#endif
#if SCREE_LANES & 8
    {self_test_lanes8, 8, "8 lanes"},
#endif
#if SCREE_LANES & 16
    {self_test_lanes16, 16, "16 lanes"},
#endif
};

// Makes values from bits alone, so that no flag changes them. A compiler cannot compute results from a volatile seed.
static void make_values(SelfTestValues* v)
{
	static volatile Word seed = 12345u;
	static const Word special[] = {0x00000000u, 0x80000000u, 0x7f800000u, 0xff800000u,
	                               0x7fc00000u, 0xffc00000u, 0x3f800000u, 0xbf800000u};
	Word word = seed;
	float* rows[] = {v->a, v->b, v->c};
	for (int i = 0; i < SELF_TEST_ITEMS; ++i)
	{
		for (int k = 0; k < 3; ++k)
		{
			word = word * 1664525u + 1013904223u;
			Word sign = word & 0x80000000u, exponent = 119u + (word >> 27 & 15u);
			word = word * 1664525u + 1013904223u;
			rows[k][i] = bits_float((int)(sign | exponent << 23 | word >> 9));
		}
		word = word * 1664525u + 1013904223u;
		v->small[i] = bits_float((int)((word & 0x80000000u) | ((word >> 8 & 0x7fffffu) + 1u)));
		v->least[i] = bits_float((int)(0x800000u + (word >> 7 & 0x7fffffu)));
		v->special[i] = bits_float((int)special[word >> 16 & 7u]);
		v->zeros[i] = bits_float((int)(word << 3 & 0x80000000u));
	}
}

// Hashes the bits of results. All NaN count as equal, because processors differ in their bits.
static Word hash_results(const float results[SELF_TEST_ROWS][SELF_TEST_ITEMS])
{
	Word hash = 0;
	for (int k = 0; k < SELF_TEST_ROWS * SELF_TEST_ITEMS; ++k)
	{
		Word word = float_word(results[k / SELF_TEST_ITEMS][k % SELF_TEST_ITEMS]);
		hash = (hash ^ ((word & 0x7fffffffu) > 0x7f800000u ? 0x7fc00000u : word)) * 0x9e3779b1u;
		hash ^= hash >> 15;
	}
	return hash;
}

SelfTest self_test_find(SelfTestFunction* function)
{
	SelfTestValues values;
	SelfTestResults results;
	make_values(&values);
	memset(&results, 0, sizeof results);
	function(&values, &results);
	for (int k = 0; k < SELF_TESTS; ++k)
		if (hash_results(results.of[k]) != tests[k].hash)
			return (SelfTest)k;
	return SELF_TESTS;
}

const char* self_test_fault(SelfTest test) { return tests[test].fault; }
const char* self_test_remedy(SelfTest test) { return tests[test].remedy; }

scree_status cpu_self_test(const char* function)
{
	static atomic_bool passed;
	if (atomic_load_explicit(&passed, memory_order_relaxed))
		return SCREE_OK;
	for (size_t k = 0; k < sizeof codes / sizeof *codes; ++k)
	{
		if (!processor_has_lanes(codes[k].lanes))
			continue;
		FloatMode mode = float_mode_enter();
		SelfTest found = self_test_find(codes[k].function);
		float_mode_leave(mode);
		if (found != SELF_TESTS)
			return fail(SCREE_ERROR_NO_DEVICE, "%s: the code for %s %s; %s", function, codes[k].name,
			            self_test_fault(found), self_test_remedy(found));
	}
	atomic_store_explicit(&passed, true, memory_order_relaxed);
	return SCREE_OK;
}
