// SPDX-License-Identifier: MIT
// rounding.c -- stores the way of rounding that a test has chosen.
#include "backend/rounding.h"

Rounding rounding_setting = ROUNDING_DEVICE;
