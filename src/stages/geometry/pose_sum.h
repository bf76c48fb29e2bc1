// SPDX-License-Identifier: MIT
// pose_sum.h -- adds to a coordinate of a body, and returns the rounding error.
//
// This work is based on:
// Donald E. Knuth, The Art of Computer Programming, volume 2, 1969, 4.2.2: the rounding error of a sum.
#ifndef POSE_SUM_H
#define POSE_SUM_H
#include "dialect/finite.h"

#define POSE_EDGE 1.0e8f // m: largest coordinate, at which bodies stop; every product of two lengths up to it is finite

// Returns a + b, limited to POSE_EDGE. *lack: exact sum minus the rounded sum; 0 if the sum is limited.
INLINE Real pose_sum(Real a, Real b, Real* lack)
{
	Real sum = a + b, back = sum - a, most = splat(POSE_EDGE);
	Int inside = (sum >= -most) & (sum <= most);
	*lack = only((a - (sum - back)) + (b - back), inside);
	return blend(within(sum, most), sum, inside);
}

#endif
