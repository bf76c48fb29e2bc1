// SPDX-License-Identifier: MIT
// allocations.h -- an allocator that fails on request of a test.
#ifndef ALLOCATIONS_H
#define ALLOCATIONS_H
#include "support/checks.h"

// From this call on the library uses an allocator with the limits below, none of which is set at first.
void count_allocations(void);
extern int allocations_left;      // number of allocations before all others fail; negative: none fails
extern size_t largest_allocation; // size of the largest allocation that succeeds, bytes
extern bool shortage_passes;      // true: only one allocation fails, then allocations_left is -1

// Checks that the call with this status failed for lack of memory, with a message. Then ends the shortage.
void end_of_shortage(scree_status status);

#endif
