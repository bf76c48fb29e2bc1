// SPDX-License-Identifier: MIT
// differences.h -- prints the differences of two snapshots.
#ifndef DIFFERENCES_H
#define DIFFERENCES_H
#include "options.h"
#include <stddef.h>

// Prints one line for each column in which two snapshots differ. On failure it prints an error message. Returns EXIT_GOOD if
// they are equal, EXIT_FAILED if they differ, EXIT_BAD if one of them is no snapshot.
int print_differences(const void* a, size_t size_a, const void* b, size_t size_b);

#endif
