// SPDX-License-Identifier: MIT
// all_pairs.c -- finds overlapping pairs of boxes by testing each box against each other: the reference of the broad
// phase.
#include "tools/paper/all_pairs.h"
#include "stages/geometry/box.h"
#include "world/check.h"

scree_status paper_pairs(const scree_box* boxes, int box_count, PaperPair* pairs, int capacity, int* count)
{
	TRY(check_batch("paper_pairs", "boxes", boxes, box_count));
	TRY(check_list("paper_pairs", "pairs", pairs, capacity, count));
	*count = 0;
	for (int a = 0; a < box_count; ++a)
		for (int b = a + 1; b < box_count; ++b)
		{
			scree_box s = boxes[a], t = boxes[b];
			if (!box_overlap(make_float4(s.lower.x, s.lower.y, s.upper.x, s.upper.y),
			                 make_float4(t.lower.x, t.lower.y, t.upper.x, t.upper.y)))
				continue;
			if (*count < capacity)
				pairs[*count] = (PaperPair){a, b};
			++*count;
		}
	return SCREE_OK;
}
