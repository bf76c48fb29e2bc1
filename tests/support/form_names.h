// SPDX-License-Identifier: MIT
// form_names.h -- defines the names of the forms of the solve and of the kinds of arithmetic, and selects them by name.
#ifndef FORM_NAMES_H
#define FORM_NAMES_H
#include "backend/arithmetic.h"
#include "backend/solve_form.h"
#include <stdio.h>
#include <string.h>

// second part of a name
static const char* const rounding_names[ROUNDING_COUNT] = {
    [ROUNDING_DEVICE] = "", [ROUNDING_OWN] = ",own", [ROUNDING_WORSE] = ",worse", [ROUNDING_WRONG] = ",wrong"};

// third part of a name, if denormals are flushed
#define FLUSH_NAME ",flush"

// Writes the name of a form and a kind of arithmetic, such as "relay,own,flush".
static inline const char* form_name(SolveForm form, Arithmetic arithmetic, char text[40])
{
	snprintf(text, 40, "%s%s%s", solve_form_names[form], rounding_names[arithmetic.rounding],
	         arithmetic.flush ? FLUSH_NAME : "");
	return text;
}

// Sets solve_form_setting and arithmetic_setting by a name. Returns false if there is no such name.
static inline bool form_choose(const char* name)
{
	char text[40];
	for (int k = 0; k < 2 * FORM_COUNT * ROUNDING_COUNT; ++k)
	{
		SolveForm form = (SolveForm)(k / 2 % FORM_COUNT);
		Arithmetic arithmetic = {.rounding = (Rounding)(k / 2 / FORM_COUNT), .flush = k % 2};
		if (strcmp(name, form_name(form, arithmetic, text)) != 0)
			continue;
		solve_form_setting = form;
		arithmetic_setting = arithmetic;
		return true;
	}
	return false;
}

#endif
