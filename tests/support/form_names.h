// SPDX-License-Identifier: MIT
// form_names.h -- names of the forms of the solve, as options of test programs.
#ifndef FORM_NAMES_H
#define FORM_NAMES_H
#include "backend/solve_form.h"
#include <string.h>

static const char* const form_names[FORM_COUNT] = {
    [FORM_ANY] = "default", [FORM_RELAY] = "relay", [FORM_TILES] = "tiles", [FORM_LAUNCHES] = "launches"};

// Sets solve_form_setting by name. Returns false if no form has the name.
static inline bool form_choose(const char* name)
{
	for (int form = 0; form < FORM_COUNT; ++form)
		if (strcmp(name, form_names[form]) == 0)
		{
			solve_form_setting = (SolveForm)form;
			return true;
		}
	return false;
}

#endif
