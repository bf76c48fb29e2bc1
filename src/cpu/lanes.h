// SPDX-License-Identifier: MIT
// lanes.h -- the compiled kernels, one table for each number of lanes.
#ifndef LANES_H
#define LANES_H
#include "backend/backend.h"

// Executes items begin to end - 1. For a wide kernel with LANES lanes, begin and end must be multiples of LANES.
typedef void (*KernelFunction)(const Pools* p, int begin, int end);

// Entries are null for kernels that are not wide; only lanes1 and scalar_avx2 have all kernels. scalar_avx2 is lanes1
// encoded as AVX2, with which the scalar code of gcc takes half as long in the narrow phase.
extern const KernelFunction kernels_lanes1[KERNEL_COUNT];
extern const KernelFunction kernels_scalar_avx2[KERNEL_COUNT];
extern const KernelFunction kernels_lanes4[KERNEL_COUNT];
extern const KernelFunction kernels_lanes8[KERNEL_COUNT];
extern const KernelFunction kernels_lanes16[KERNEL_COUNT];

#endif
