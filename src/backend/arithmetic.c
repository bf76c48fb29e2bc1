// SPDX-License-Identifier: MIT
// arithmetic.c -- stores the arithmetic that a test has chosen.
#include "backend/arithmetic.h"

Arithmetic arithmetic_setting = {.rounding = ROUNDING_DEVICE};
