// SPDX-License-Identifier: MIT
// lanes.h -- the compiled stages, one table for each number of lanes.
#ifndef LANES_H
#define LANES_H
#include "backend/backend.h"

// Executes items begin to end - 1. A wide stage with LANES lanes needs begin and end to be multiples of LANES.
typedef void (*KernelFunction)(const Pools* p, int begin, int end);

// Null for a stage that is not wide. Only lanes1 and scalar_avx2 have all stages. scalar_avx2 differs from lanes1 in its instruction
// set only: encoded as AVX2, the scalar code of gcc takes half as long in narrow phase.
extern const KernelFunction kernels_lanes1[KERNEL_COUNT];
extern const KernelFunction kernels_scalar_avx2[KERNEL_COUNT];
extern const KernelFunction kernels_lanes4[KERNEL_COUNT];
extern const KernelFunction kernels_lanes8[KERNEL_COUNT];
extern const KernelFunction kernels_lanes16[KERNEL_COUNT];

#endif
