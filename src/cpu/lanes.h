// SPDX-License-Identifier: MIT
// lanes.h -- declares the tables of compiled kernels, one table for each number of lanes.
#ifndef LANES_H
#define LANES_H
#include "backend/backend.h"

// Executes items begin to end - 1 of a kernel. For a wide kernel, both must be multiples of the number of lanes.
typedef void (*KernelFunction)(const Pools* p, int begin, int end);

// Tables of 4, 8 and 16 lanes contain only wide kernels and group kernels, and null for all others. scalar_avx2 is
// lanes1 compiled for AVX2; with gcc its narrow phase takes half the time.
extern const KernelFunction kernels_lanes1[KERNEL_COUNT];
extern const KernelFunction kernels_scalar_avx2[KERNEL_COUNT];
extern const KernelFunction kernels_lanes4[KERNEL_COUNT];
extern const KernelFunction kernels_lanes8[KERNEL_COUNT];
extern const KernelFunction kernels_lanes16[KERNEL_COUNT];

#endif
