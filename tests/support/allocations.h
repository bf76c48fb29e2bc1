// SPDX-License-Identifier: MIT
// allocations.h -- an allocator that fails when a test says so.
#ifndef ALLOCATIONS_H
#define ALLOCATIONS_H
#include "support/checks.h"

// From here on the library takes its memory from an allocator with these limits, which begin without any.
void count_allocations(void);
extern int allocations_left;      // before all others fail; negative: none does
extern size_t largest_allocation; // that is granted, bytes
extern bool shortage_passes;      // one allocation fails, and allocations_left is -1 from then on

// The call with this status must have failed for lack of memory, and said so. From here on there is memory again.
void end_of_shortage(scree_status status);

#endif
