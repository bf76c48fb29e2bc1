// SPDX-License-Identifier: MIT
// lanes1.c -- compiles all kernels for one item per call.
#define LANES 1
#include "stages/all_stages.h"

#include "cpu/kernel_table.h"
