// SPDX-License-Identifier: MIT
// pose.h -- moves a body's center of mass, and stores the rounding errors of its coordinates.
//
// Coordinates are rounded, to 2 um at 24 m from the origin. Without the stored errors slow bodies would stop, and heaps
// at rest would creep (docs/design/manifolds.md, Rounding residuals).
#ifndef POSE_H
#define POSE_H
#include "pools/pools.h"
#include "stages/geometry/pose_sum.h"

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
