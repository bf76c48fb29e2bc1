// SPDX-License-Identifier: MIT
// finite.h -- what keeps state finite: bounds beyond which a number is not taken, so that neither NaN nor infinity is stored.
//
// Compilers agree on which results are NaN, but not on the sign and the rest of its bits, so a NaN that is stored is a
// difference. docs/determinism.md has the rule and, stage by stage, how it is kept.
#ifndef FINITE_H
#define FINITE_H
#include "stages/vec.h"

// m/s, m/s^2, rad/s, ...: sums of some of these, and their products with a substep, stay finite
#define MOST_RATE 1.0e30f
// N, N m: forces collect between steps
#define MOST_FORCE 3.0e38f
// N s: the momentum of the heaviest body (1e30 kg) at the highest max_speed
#define MOST_IMPULSE 1.0e35f
// of a pair of surfaces: times the largest impulse it is still finite
#define MOST_FRICTION 1.0e3f

// x within bounds; NaN stays, for finalize to find
INLINE Real within(Real x, Real most) { return maximum(minimum(x, most), -most); }

// An impulse that pushes: none when it would pull, is no number or is beyond all bounds. So a body whose velocity is no
// number pushes nobody, and is the only one to be frozen; and no zero is negative.
INLINE Real push_of(Real x) { return choose(splat(0.0f), x, (x > splat(0.0f)) & (x <= splat(MOST_IMPULSE))); }

// An impulse within a limit on either side, which is finite; what is no number becomes the limit.
INLINE Real grip_of(Real x, Real limit) { return minimum(limit, maximum(-limit, x)); }

// What to scale a vector by, to be no longer than some length: 1 when it is not. The square of a long one is not finite.
INLINE Real vec_shrink(Vec v, float length)
{
	Real square = vec_dot(v, v);
	Real near = choose(splat(1.0f), splat(8.8817842e-16f), square > splat(1.0e36f)); // 2^-50
	Vec shorter = vec_scale(near, v);
	return choose(splat(1.0f), near * length / root(vec_dot(shorter, shorter)), square > splat(length * length));
}

#endif
