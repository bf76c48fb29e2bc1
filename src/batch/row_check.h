// SPDX-License-Identifier: MIT
// row_check.h -- checks the items of a row, which may come from anywhere, before a batch gets them.
#ifndef ROW_CHECK_H
#define ROW_CHECK_H
#include "batch/world_row.h"

// Fails with SCREE_ERROR_INVALID if a kernel could read or write beyond a pool, or if the structure of the world
// (fingerprint.h) is not that of the template. row_open has checked the head, and the numbers of items are those of the
// template. row: need not be aligned. function, number: for messages, the name of the caller and the index of the row.
scree_status row_check(const char* row, const RowHead* head, const Template* from, const char* function, int number);

#endif
