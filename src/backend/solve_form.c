// SPDX-License-Identifier: MIT
// solve_form.c -- the form of a solve that tests choose.
#include "backend/solve_form.h"

SolveForm solve_form_setting = FORM_ANY;
