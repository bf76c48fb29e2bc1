// SPDX-License-Identifier: MIT
// scalar_avx2.c -- compiles all kernels for one item per call, with the instructions of eight lanes: AVX2 on x86.
#define LANES     1
#define TABLE     kernels_scalar_avx2
#define SELF_TEST self_test_scalar_avx2
#include "stages/all_stages.h"

#include "cpu/kernel_table.h"
