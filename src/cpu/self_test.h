// SPDX-License-Identifier: MIT
// self_test.h -- declares the self-test: about a thousand float operations against stored results, which find builds
// with wrong compiler flags. WebAssembly has no self-test: its standard defines floats, and no flag changes them.
#ifndef SELF_TEST_H
#define SELF_TEST_H

#define SELF_TEST_ITEMS 32 // a multiple of 2 * MAX_LANES
#define SELF_TEST_ROWS  4

typedef enum
{
#define X(name, hash, fault, remedy) SELF_TEST_##name,
#include "cpu/self_test.def"
#undef X
	SELF_TESTS
} SelfTest;

typedef struct
{
	_Alignas(64) float a[SELF_TEST_ITEMS]; // 2^-8 to 2^8, both signs
	_Alignas(64) float b[SELF_TEST_ITEMS], c[SELF_TEST_ITEMS];
	_Alignas(64) float small[SELF_TEST_ITEMS];   // denormals, both signs
	_Alignas(64) float least[SELF_TEST_ITEMS];   // 1.18e-38 to 2.35e-38: the least exponent of a normal number
	_Alignas(64) float special[SELF_TEST_ITEMS]; // 0, -0, infinities, NaN, numbers
	_Alignas(64) float zeros[SELF_TEST_ITEMS];   // 0 and -0
} SelfTestValues;

typedef struct
{
	_Alignas(64) float of[SELF_TESTS][SELF_TEST_ROWS][SELF_TEST_ITEMS];
} SelfTestResults;

// Computes the results of all parts with the compiler flags of the file that defines it.
typedef void SelfTestFunction(const SelfTestValues* v, SelfTestResults* r);
SelfTestFunction self_test_host, self_test_lanes1, self_test_scalar_avx2, self_test_lanes4, self_test_lanes8,
    self_test_lanes16;

// Returns the first part with a wrong result, or SELF_TESTS.
SelfTest self_test_find(SelfTestFunction* function);
const char* self_test_fault(SelfTest test);
const char* self_test_remedy(SelfTest test);

#endif
