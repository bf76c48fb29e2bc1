// SPDX-License-Identifier: MIT
// all_pairs.h -- overlapping pairs of boxes, found by testing each against each: the reference of the broad phase.
#ifndef ALL_PAIRS_H
#define ALL_PAIRS_H
#include "scree/scree.h"

typedef struct
{
	int a, b; // a < b
} PaperPair;

// Tests every box against every other, the edges included. Writes up to capacity overlapping pairs, by rising a, then b,
// and the number of all overlapping pairs.
scree_status paper_pairs(const scree_box* boxes, int box_count, PaperPair* pairs, int capacity, int* count);

#endif
