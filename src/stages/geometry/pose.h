// SPDX-License-Identifier: MIT
// pose.h -- moves a body's center of mass, and stores the rounding errors of its coordinates.
//
// This work is based on:
// Donald E. Knuth, The Art of Computer Programming, volume 2, 1969, 4.2.2: the rounding error of a sum.
//
// Coordinates are rounded, to 2 um at 24 m from the origin. Without the stored errors slow bodies would stop, and heaps
// at rest would creep (docs/design/manifolds.md, Rounding residuals).
#ifndef POSE_H
#define POSE_H
#include "dialect/finite.h"
#include "pools/pools.h"

#define POSE_EDGE 1.0e8f // m: largest coordinate, at which bodies stop; every product of two lengths up to it is finite

#if LANES == 1 // finalize_wide.h has these functions for several lanes

// Returns a + b, limited to POSE_EDGE. *lack: exact sum minus the rounded sum; 0 if the sum is limited.
INLINE float pose_sum(float a, float b, float* lack)
{
	float sum = a + b, back = sum - a;
	*lack = (a - (sum - back)) + (b - back);
	if (sum >= -POSE_EDGE && sum <= POSE_EDGE)
		return sum;
	*lack = 0.0f;
	return within(sum, POSE_EDGE);
}

// Moves body i by d (m), which is finite, and sets its rotation.
INLINE void pose_move(const Pools* p, int i, Vec d, Vec rotation)
{
	Float4 pose = p->pose[i];
	Float2 low = p->pose_low[i];
	float lack_x, lack_y;
	float x = pose_sum(pose.x, d.x + low.x, &lack_x), y = pose_sum(pose.y, d.y + low.y, &lack_y);
	p->pose[i] = make_float4(x, y, rotation.x, rotation.y);
	p->pose_low[i] = make_float2(lack_x, lack_y);
}

#endif

#endif
