// SPDX-License-Identifier: MIT
// arithmetic.h -- declares the kinds of arithmetic with equal bits, and the variable with which a test chooses one.
#ifndef ARITHMETIC_H
#define ARITHMETIC_H
#include "platform/exact_floats.h"
#include <stdbool.h>

typedef enum // rounding of quotients and roots on OpenCL devices
{
	ROUNDING_DEVICE, // by the device if it reports to round them correctly and does, otherwise by own_rounding.h
	ROUNDING_OWN,    // by dialect/own_rounding.h
	ROUNDING_WORSE,  // by dialect/own_rounding.h, from results to which errors of -2 to 2 ulp are added
	ROUNDING_WRONG,  // as with ROUNDING_DEVICE, but the device adds these errors without reporting it
	ROUNDING_COUNT
} Rounding;

typedef struct
{
	Rounding rounding;
	bool flush; // denormal operands and results count as 0, as on devices without them
	bool fused; // OpenCL devices may fuse products and sums, so bits differ: such a device must fail its test
} Arithmetic;

// Arithmetic of devices that are opened later. Only tests change it.
extern Arithmetic arithmetic_setting;

#endif
