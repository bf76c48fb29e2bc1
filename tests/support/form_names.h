// SPDX-License-Identifier: MIT
// form_names.h -- defines the names of the forms of the solve and of the ways of rounding, and selects them by name.
#ifndef FORM_NAMES_H
#define FORM_NAMES_H
#include "backend/rounding.h"
#include "backend/solve_form.h"
#include <stdio.h>
#include <string.h>

static const char* const form_names[FORM_COUNT] = {
    [FORM_ANY] = "default", [FORM_RELAY] = "relay", [FORM_TILES] = "tiles", [FORM_LAUNCHES] = "launches"};

// second part of a name, after the form
static const char* const rounding_names[ROUNDING_COUNT] = {
    [ROUNDING_DEVICE] = "", [ROUNDING_OWN] = ",own", [ROUNDING_WORSE] = ",worse"};

// Writes the name of a form and a way of rounding, such as "relay,own".
static inline const char* form_name(SolveForm form, Rounding rounding, char text[32])
{
	snprintf(text, 32, "%s%s", form_names[form], rounding_names[rounding]);
	return text;
}

// Sets solve_form_setting and rounding_setting by a name. Returns false if there is no such name.
static inline bool form_choose(const char* name)
{
	char text[32];
	for (int k = 0; k < FORM_COUNT * ROUNDING_COUNT; ++k)
	{
		SolveForm form = (SolveForm)(k % FORM_COUNT);
		Rounding rounding = (Rounding)(k / FORM_COUNT);
		if (strcmp(name, form_name(form, rounding, text)) != 0)
			continue;
		solve_form_setting = form;
		rounding_setting = rounding;
		return true;
	}
	return false;
}

#endif
