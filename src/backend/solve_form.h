// SPDX-License-Identifier: MIT
// solve_form.h -- declares the forms of a solve on OpenCL devices, and the variable with which a test chooses one.
#ifndef SOLVE_FORM_H
#define SOLVE_FORM_H
#include "platform/exact_floats.h"

typedef enum
{
	FORM_ANY, // the backend chooses the form that it expects to be fastest
	FORM_RELAY,
	FORM_TILES,
	FORM_LAUNCHES, // one launch per color and pass
	FORM_COUNT,
	FORM_BAYS = FORM_COUNT // the default form of a batch, chosen only by the backend
} SolveForm;

// Form of the solve for devices that are opened later. Only tests change it. FORM_RELAY and FORM_TILES apply to OpenCL
// CPUs, too, and let the persistent kernel execute long runs. With FORM_LAUNCHES that kernel executes no runs.
extern SolveForm solve_form_setting;

extern const char* const solve_form_names[FORM_COUNT]; // "default", "relay", "tiles", "launches"

#endif
