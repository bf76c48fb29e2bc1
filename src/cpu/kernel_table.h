// SPDX-License-Identifier: MIT
// kernel_table.h -- defines the table of the kernels of lanesN.c or scalar_avx2.c; included at the end of these files.
#include "cpu/lanes.h"
#ifndef SCREE_SMALL
#include "cpu/self_test_lanes.h"
#endif

#ifndef TABLE
#define TABLE KERNEL_JOIN(kernels, LANES)
#endif

// With SCREE_SMALL, for WebAssembly, each kernel is compiled once: wide kernels with the number of lanes of the build,
// and group kernels, which have the most code, and rare wide kernels with one lane.
#if LANES == 1
#define ENTRY_ONE(name) KERNEL_JOIN(name, LANES)
#else
#define ENTRY_ONE(name) NULL
#endif
#if LANES > 1 || SCREE_LANES & 1
#define ENTRY_WIDE(name) KERNEL_JOIN(name, LANES)
#else
#define ENTRY_WIDE(name) NULL
#endif
#ifdef SCREE_SMALL
#define ENTRY_GROUP(name)      ENTRY_ONE(name)
#define ENTRY_WIDE_ALONE(name) ENTRY_ONE(name)
#else
#define ENTRY_GROUP(name)      KERNEL_JOIN(name, LANES)
#define ENTRY_WIDE_ALONE(name) ENTRY_WIDE(name)
#endif
#define ENTRY_ALONE(name) ENTRY_ONE(name)
#define ENTRY_TEAM(name)  ENTRY_ONE(name)

// clang-format off
const KernelFunction TABLE[KERNEL_COUNT] = {
#define X(name, width, box) ENTRY_##width(name),
#include "stages/kernels.def"
#undef X
};
