// SPDX-License-Identifier: MIT
// allocations.h -- an allocator that fails when a test requests it.
#ifndef ALLOCATIONS_H
#define ALLOCATIONS_H
#include "support/checks.h"

// Makes the library use an allocator with the limits below from now on. At first no limit is set.
void count_allocations(void);
extern int allocations_left;      // number of allocations that succeed before all others fail; negative: no limit
extern size_t largest_allocation; // size of the largest allocation that succeeds, bytes
extern bool shortage_passes;      // true: only one allocation fails; then allocations_left becomes -1

// Checks that `status` reports a lack of memory and that there is a message about memory. Then ends the shortage.
void end_of_shortage(scree_status status);

#endif
