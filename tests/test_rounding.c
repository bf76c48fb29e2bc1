// SPDX-License-Identifier: MIT
// test_rounding.c -- checks own rounding: quotients and roots from results with errors of up to 3 ulp equal those of the
// processor; so does the factor of nearly normalized vectors, which is computed from bits.
//
// make test checks 3 million random quotients and 4 million roots, make test-full a hundred times as many.
// SCREE_ROUNDINGS is another number of quotients.
#define LANES 1
#include "dialect/dialect.h"

static int error_ulps; // error that is added to each result before it is corrected

static float inexact(float x) { return bits_float(float_bits(x) + error_ulps); }
#define inexact_quotient(a, b) inexact((a) / (b))
#define inexact_root(x)        inexact(square_root(x))
#include "dialect/own_rounding.h"

#include "dialect/vec.h"
#include "support/checks.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>

#define LARGEST_ERROR 3

static bool same(float a, float b) { return a != a ? b != b : float_word(a) == float_word(b); }

// Returns a pair of floats for case k: any bits, denormal operands, denormal results, near ties, specials.
static void operands(int k, uint64_t* seed, float* a, float* b)
{
	uint64_t bits = random_word(seed);
	Word x = (Word)bits, y = (Word)(bits >> 32), sign = 0x80000000u, mantissa = 0x7fffffu;
	switch (k % 16)
	{
	case 0: // denormal dividend
		x &= sign | mantissa;
		break;
	case 1: // denormal divisor
		y &= sign | mantissa;
		break;
	case 2:
	case 3: // denormal quotient
		x = (x & (sign | mantissa)) | (Word)(1 + k / 16 % 30) << 23;
		y = (y & (sign | mantissa)) | (Word)(127 + k / 16 % 25) << 23;
		break;
	case 4: // dividend with few bits, divisor near 2: quotients near ties
		x &= 0xffff0003u;
		y = (y & 0xff800000u) | (mantissa - (y & 3u));
		break;
	case 5: // mantissas that are nearly equal
		y = (y & ~mantissa) | ((x + (y & 3u)) & mantissa);
		break;
	case 6: // zero, infinity and NaN
		x = k & 16 ? x & sign : x | 0x7f800000u;
		x = k & 32 ? x & (sign | 0x7f800000u) : x;
		break;
	case 7:
		y = k & 16 ? y & sign : y | 0x7f800000u;
		y = k & 32 ? y & (sign | 0x7f800000u) : y;
		break;
	default:
		break;
	}
	*a = bits_float((int)x);
	*b = bits_float((int)y);
}

static long long pairs(void)
{
	const char* wanted = getenv("SCREE_ROUNDINGS");
	return wanted ? atoll(wanted) : quick() ? 3000000 : 300000000;
}

static void test_quotients(void** state)
{
	(void)state;
	uint64_t seed = 1;
	long long denormal = 0;
	for (long long k = 0; k < pairs(); ++k)
	{
		float a, b;
		operands((int)(k & 0xffff), &seed, &a, &b);
		error_ulps = (int)(random_word(&seed) % (2 * LARGEST_ERROR + 1)) - LARGEST_ERROR;
		volatile float expected = a / b;
		float got = own_quotient(a, b);
		denormal += expected != 0.0f && fabsf(expected) < 1.17549435e-38f;
		if (!same(expected, got))
			fail_msg("%a / %a is %a, not %a (error of %d ulp)", (double)a, (double)b, (double)expected, (double)got,
			         error_ulps);
	}
	print_message("%lld quotients, %lld of them denormal\n", pairs(), denormal);
	assert_true(denormal > pairs() / 50);
}

static void test_roots(void** state)
{
	(void)state;
	// nearly every mantissa with even and odd exponents, and a part of all other floats
	Word dense = (Word)(150000000 / pairs()) + 1, sparse = 100 * dense;
	long long count = 0;
	for (error_ulps = -LARGEST_ERROR; error_ulps <= LARGEST_ERROR; ++error_ulps)
	{
		for (uint64_t w = 0; w <= 0xffffffffu; w += w >= 0x3f800000u && w < 0x40800000u ? dense : sparse, ++count)
		{
			float x = bits_float((int)(Word)w), got = own_root(x);
			volatile float expected = square_root(x);
			if (!same(expected, got))
				fail_msg("the root of %a is %a, not %a (error of %d ulp)", (double)x, (double)expected, (double)got,
				         error_ulps);
		}
	}
	print_message("%lld roots\n", count);
}

// Checks all squares near 1, on both sides of the bounds of the fast case, and others of every size.
static void test_unit_factor(void** state)
{
	(void)state;
	int one = float_bits(1.0f), count = 0;
	for (int bits = 0; bits <= float_bits(INFINITY);
	     bits += abs(bits - one) < 2 * UNIT_ULPS ? 1 : UNIT_ULPS - 1, ++count)
	{
		float square = bits_float(bits);
		volatile float root = square_root(square), expected = 1.0f / root;
		if (!same(expected, unit_factor(square)))
			fail_msg("the factor of %a is %a, not %a", (double)square, (double)unit_factor(square), (double)expected);
	}
	assert_true(count > 4 * UNIT_ULPS);
	assert_true(isnan(unit_factor(NAN)));
	assert_true(unit_factor(INFINITY) == 0.0f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_quotients), cmocka_unit_test(test_roots),
	                                   cmocka_unit_test(test_unit_factor)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
