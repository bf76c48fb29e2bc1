// SPDX-License-Identifier: MIT
// lanes1.c -- all stages, one item a call.
#define LANES 1
#include "stages/all_stages.h"

#include "cpu/kernel_table.h"
