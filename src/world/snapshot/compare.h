// SPDX-License-Identifier: MIT
// compare.h -- finds the columns in which two snapshots differ.
#ifndef COMPARE_H
#define COMPARE_H
#include "world/snapshot/columns.h"

// Writes up to `capacity` differences, in the order of the columns, and sets count to the number of columns that differ. stride:
// bytes from one difference to the next. Fails with SCREE_ERROR_INVALID if a snapshot is damaged.
scree_status snapshots_compare(const char* function, const void* a, size_t size_a, const void* b, size_t size_b,
                               void* differences, size_t stride, int capacity, int* count);

#endif
