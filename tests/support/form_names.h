// SPDX-License-Identifier: MIT
// form_names.h -- defines the names of the forms of the solve, and selects a form by its name.
#ifndef FORM_NAMES_H
#define FORM_NAMES_H
#include "backend/solve_form.h"
#include <string.h>

static const char* const form_names[FORM_COUNT] = {
    [FORM_ANY] = "default", [FORM_RELAY] = "relay", [FORM_TILES] = "tiles", [FORM_LAUNCHES] = "launches"};

// Sets solve_form_setting to the form with this name. Returns false if there is no such form.
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
