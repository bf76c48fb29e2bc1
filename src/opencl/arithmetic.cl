// SPDX-License-Identifier: MIT
// arithmetic.cl -- contains the program that tests the arithmetic of a device: a kernel that computes all results.
#include "dialect/dialect.h"
#define N(x) (x)
#include "opencl/arithmetic_item.h"

__kernel void arithmetic(__global uint* results)
{
	int i = (int)get_global_id(0);
	if (i < ARITHMETIC_RESULTS)
		results[i] = arithmetic_result(i / ARITHMETIC_CASES, i % ARITHMETIC_CASES);
}
