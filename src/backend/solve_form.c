// SPDX-License-Identifier: MIT
// solve_form.c -- stores the form of a solve that a test has chosen.
#include "backend/solve_form.h"

SolveForm solve_form_setting = FORM_ANY;
