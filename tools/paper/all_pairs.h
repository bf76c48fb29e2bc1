// SPDX-License-Identifier: MIT
// all_pairs.h -- finds overlapping pairs of boxes by testing each box against each other: the reference of the broad
// phase.
#ifndef ALL_PAIRS_H
#define ALL_PAIRS_H
#include "scree/scree.h"

typedef struct
{
	int a, b; // indices of two boxes, a < b
} PaperPair;

// Tests every box against every other; boxes whose edges touch overlap. Writes at most `capacity` overlapping pairs, in
// ascending order of their index `a`, then `b`. Writes the number of all overlapping pairs to *count.
scree_status paper_pairs(const scree_box* boxes, int box_count, PaperPair* pairs, int capacity, int* count);

#endif
