// SPDX-License-Identifier: MIT
// rounding.h -- declares the ways in which OpenCL programs round, and the variable with which a test chooses one.
#ifndef ROUNDING_H
#define ROUNDING_H
#include "platform/exact_floats.h"

typedef enum
{
	ROUNDING_DEVICE, // by the device if it rounds quotients and roots correctly, otherwise by dialect/own_rounding.h
	ROUNDING_OWN,    // by dialect/own_rounding.h
	ROUNDING_WORSE,  // by dialect/own_rounding.h, from results to which errors of -2 to 2 ulp are added
	ROUNDING_COUNT
} Rounding;

// Rounding of devices that are opened later. Only tests change it.
extern Rounding rounding_setting;

#endif
