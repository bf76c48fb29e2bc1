// SPDX-License-Identifier: MIT
// solve_form.h -- the forms of a solve on OpenCL devices.
#ifndef SOLVE_FORM_H
#define SOLVE_FORM_H

typedef enum
{
	FORM_ANY, // the fastest one
	FORM_RELAY,
	FORM_TILES,
	FORM_LAUNCHES, // launches by color
	FORM_COUNT
} SolveForm;

// Form of the solve on devices that are opened from here on. Only tests change it. FORM_RELAY and FORM_TILES also apply
// to CPUs, and the persistent kernel then executes long runs too. With FORM_LAUNCHES it executes none.
extern SolveForm solve_form_setting;

#endif
