// SPDX-License-Identifier: MIT
// self_test_lanes.h -- defines the operations of the self-test for a number of lanes; part of kernel_table.h, so that
// they have the compiler flags of the stages. SELF_TEST: the name of the function.
#include "cpu/self_test.h"
#include "dialect/dialect.h"

#ifndef SELF_TEST
#define SELF_TEST KERNEL_JOIN(self_test, LANES)
#endif

#define put(part, row, i, x) store(r->of[SELF_TEST_##part][row], i, x)
#define truth(condition)     blend(splat(0.0f), splat(1.0f), condition)

static void test_sums(const SelfTestValues* v, SelfTestResults* r)
{
	for (int i = 0; i < SELF_TEST_ITEMS; i += LANES)
	{
		Real a = load(v->a, i), b = load(v->b, i), c = load(v->c, i);
		put(NEAREST, 0, i, a + b);
		put(NEAREST, 1, i, b - c);
		put(FUSED, 0, i, a * b + c);
		put(FUSED, 1, i, a - b * c);
		put(ORDER, 0, i, a + b - a);
		put(ORDER, 1, i, (a - b) - (c - b));
		put(QUOTIENTS, 0, i, a / c);
		put(QUOTIENTS, 1, i, b / c);
		put(QUOTIENTS, 2, i, 1.0f / c);
		put(QUOTIENTS, 3, i, a / splat(3.0f));
		put(ROOTS, 0, i, root(maximum(a, -a)));
		put(ROOTS, 1, i, 1.0f / root(maximum(c, -c)));
		put(ROOTS, 2, i, root(b * b));
	}
#if LANES == 1
	// gcc pairs a difference and a sum in one instruction, vfmaddsub
	for (int i = 0; i < SELF_TEST_ITEMS; i += 2)
	{
		put(FUSED, 2, i, v->c[i] * v->a[i] - v->b[i]);
		put(FUSED, 2, i + 1, v->c[i + 1] * v->a[i + 1] + v->b[i + 1]);
	}
#else
	for (int i = 0; i < SELF_TEST_ITEMS; i += LANES)
	{
		Real b = load(v->b, i);
		put(FUSED, 2, i, load(v->c, i) * load(v->a, i) + blend(-b, b, (indices(i) & 1) != 0));
	}
#endif
	float sum = 0.0f;
	for (int i = 0; i < SELF_TEST_ITEMS; ++i)
		sum += v->a[i];
	r->of[SELF_TEST_ORDER][2][0] = sum;
}

static void test_special(const SelfTestValues* v, SelfTestResults* r)
{
	for (int i = 0; i < SELF_TEST_ITEMS; i += LANES)
	{
		Real a = load(v->a, i), b = load(v->b, i), small = load(v->small, i), least = load(v->least, i);
		Real x = load(v->special, i), zero = load(v->zeros, i);
		put(SMALL_RESULTS, 0, i, a * least);
		put(SMALL_RESULTS, 1, i, least - splat(1.18e-38f));
		put(SMALL_OPERANDS, 0, i, small * splat(1e20f));
		put(SMALL_OPERANDS, 1, i, truth(small > splat(0.0f)));
		put(SMALL_OPERANDS, 2, i, small + least);
		put(ZEROS, 0, i, zero + splat(0.0f));
		put(ZEROS, 1, i, splat(0.0f) - zero);
		put(ZEROS, 2, i, a * splat(0.0f));
		put(ZEROS, 3, i, -(zero - a * splat(0.0f)));
		put(UNORDERED, 0, i, truth(x != x));
		put(UNORDERED, 1, i, truth(x < b));
		put(UNORDERED, 2, i, blend(splat(1.0f), splat(0.0f), x >= b));
		put(UNORDERED, 3, i, truth(x - x == splat(0.0f)));
		put(EXTREMES, 0, i, blend(minimum(b, x), b, x != x));
		put(EXTREMES, 1, i, blend(maximum(b, x), b, x != x));
		put(EXTREMES, 2, i, minimum(zero, splat(0.0f)));
		put(EXTREMES, 3, i, maximum(zero, splat(0.0f)));
		Real positive = maximum(a, -a) * splat(1000.0f);
		put(WHOLES, 0, i, real_of(whole(positive)));
		put(WHOLES, 1, i, real_of(indices(i) * 3 + 16777217));
	}
}

void SELF_TEST(const SelfTestValues* v, SelfTestResults* r)
{
	test_sums(v, r);
	test_special(v, r);
}

#undef put
#undef truth
