// SPDX-License-Identifier: MIT
// scalar_avx2.c -- all kernels, one item per call, with the instructions that eight lanes need: AVX2 on x86.
#define LANES 1
#define TABLE kernels_scalar_avx2
#include "stages/all_stages.h"

#include "cpu/kernel_table.h"
