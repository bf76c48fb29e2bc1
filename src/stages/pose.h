// SPDX-License-Identifier: MIT
// pose.h -- where the center of mass of a body goes, and what the rounding of its coordinates leaves over.
//
// This work is based on:
// Donald E. Knuth, The Art of Computer Programming, volume 2, 1969, 4.2.2: the rounding error of a sum.
//
// 24 m from the origin a coordinate is rounded to 2 um. What is pushed by less in a step would stay, again and again, and what
// is pushed by a little more would go further than it was pushed: heaps at rest creep by some mm a minute, and what drifts at
// 1 mm/s stops a kilometre from the origin. So each body keeps what was left over, and takes it along in its next step.
#ifndef POSE_H
#define POSE_H
#include "dialect/finite.h"
#include "pools/pools.h"

// m: the edge of the world, where bodies stop. Every product of two lengths within it is finite.
#define POSE_EDGE 1.0e8f

// a + b, and what it lacks
INLINE float pose_sum(float a, float b, float* lack)
{
	float sum = a + b, back = sum - a;
	*lack = (a - (sum - back)) + (b - back);
	if (sum >= -POSE_EDGE && sum <= POSE_EDGE)
		return sum;
	*lack = 0.0f;
	return within(sum, POSE_EDGE);
}

// Body i goes by d (m), which is finite, and has a rotation.
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
