// SPDX-License-Identifier: MIT
// cpu.h -- the first three stages on the CPU: one thread, one item after the other.
#ifndef REFERENCE_CPU_H
#define REFERENCE_CPU_H
#include "reference/state.h"

// Runs the first three stages. The contacts are in the pool of the host, in any order.
scree_status paper_cpu_run(Paper* paper);

#endif
