// SPDX-License-Identifier: MIT
// solve_form.c -- stores the form of a solve that a test has chosen, and the names of the forms.
#include "backend/solve_form.h"

SolveForm solve_form_setting = FORM_ANY;

const char* const solve_form_names[FORM_COUNT] = {
    [FORM_ANY] = "default", [FORM_RELAY] = "relay", [FORM_TILES] = "tiles", [FORM_LAUNCHES] = "launches"};
