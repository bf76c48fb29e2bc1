// SPDX-License-Identifier: MIT
// arithmetic_test.h -- tests the arithmetic of a device against that of the CPU.
#ifndef ARITHMETIC_TEST_H
#define ARITHMETIC_TEST_H
#include "opencl/device.h"

#define ARITHMETIC_OPTIONS 64 // maximum size of the options below in bytes, with the final zero

// Writes the build options for own rounding, and for the arithmetic that a test has chosen (backend/arithmetic.h).
void arithmetic_options(bool own_rounding, char text[ARITHMETIC_OPTIONS]);

// Compares results of a device with those of the CPU. Returns the operation of the first difference, which it writes
// to the verdict, or ARITHMETIC_OPERATIONS. results: ARITHMETIC_RESULTS words (arithmetic_item.h).
int arithmetic_compare(const uint32_t* results, Verdict* verdict);

// Computes ARITHMETIC_RESULTS float results on the device and on the CPU, and sets all members of the verdict but
// `worlds`. If the device rounds quotients or roots wrongly, the results are computed again with own rounding. Fails
// only if an OpenCL call fails. limit: that of wait_for, s.
scree_status arithmetic_test(const Device* device, double limit, Verdict* verdict);

#endif
