// SPDX-License-Identifier: MIT
// paper_cpu.h -- the first three stages on the CPU: one thread, one item after the other.
#ifndef PAPER_CPU_H
#define PAPER_CPU_H
#include "tools/paper/paper_state.h"

// Runs the first three stages. The contacts are in the pool of the host, in any order.
scree_status paper_cpu_run(Paper* paper);

#endif
