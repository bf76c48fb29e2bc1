// SPDX-License-Identifier: MIT
// lanes1.c -- all kernels, one item per call.
#define LANES 1
#include "stages/all_stages.h"

#include "cpu/kernel_table.h"
