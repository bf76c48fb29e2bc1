// SPDX-License-Identifier: MIT
// one8.c -- all stages, one item a call, with the instructions that eight lanes need: AVX2 on x86.
#define LANES 1
#define TABLE stages_one8
#include "stages/program.h"

#include "cpu/table.h"
