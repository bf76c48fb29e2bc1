// SPDX-License-Identifier: MIT
// paper_cpu.h -- executes the first three stages on the CPU, in one thread, one item after the other.
#ifndef PAPER_CPU_H
#define PAPER_CPU_H
#include "tools/paper/paper_state.h"

// Executes the first three stages. Afterwards the contact pool of the host has the contacts, in no order.
scree_status paper_cpu_run(Paper* paper);

#endif
