// SPDX-License-Identifier: MIT
// finite.h -- keeps state finite: NaN is never stored, and sums of the user's calls end at the largest number.
//
// Devices agree on which results are NaN, but not on the sign and the payload of a NaN, so a stored NaN is a difference
// between devices. docs/determinism.md has the rule and how each stage keeps it.
#ifndef FINITE_H
#define FINITE_H
#include "dialect/vec.h"

#define MOST_FLOAT 3.40282347e38f
// N s: the momentum of the heaviest body (1e30 kg) at the highest max_speed
#define MOST_IMPULSE 1.0e35f
// of a pair of surfaces: times the largest impulse it is still finite
#define MOST_FRICTION 1.0e3f

// x within bounds; NaN stays NaN.
INLINE Real within(Real x, Real most) { return maximum(minimum(x, most), -most); }

// The largest number of its sign in place of an infinity: what is stored of the user's sums.
INLINE float finite_or_most(float x) { return x > MOST_FLOAT ? MOST_FLOAT : x < -MOST_FLOAT ? -MOST_FLOAT : x; }

// Zero in place of NaN.
INLINE Real number_of(Real x) { return blend(splat(0.0f), x, x == x); }

// The same, and the largest number of its sign in place of an infinity.
INLINE Real finite_of(Real x) { return number_of(within(x, splat(MOST_FLOAT))); }

// An impulse that pushes: zero if it would pull, is NaN or exceeds MOST_IMPULSE. So a body with a NaN velocity pushes no
// other body and is the only one to be frozen; and no zero is negative.
INLINE Real push_of(Real x) { return blend(splat(0.0f), x, (x > splat(0.0f)) & (x <= splat(MOST_IMPULSE))); }

// An impulse within a finite limit on either side; NaN becomes the limit.
INLINE Real grip_of(Real x, Real limit) { return minimum(limit, maximum(-limit, x)); }

// The factor that makes a vector no longer than some length: 1 if it is shorter. The square of a long vector is not
// finite; a vector that is not finite becomes NaN.
INLINE Real vec_shrink(Vec v, float length)
{
	Real square = vec_dot(v, v);
	Real unit = blend(splat(1.0f), splat(1.35525272e-20f), square > splat(1.0e36f)); // 2^-66
	Vec shorter = vec_scale(unit, v);
	return blend(splat(1.0f), unit * length / root(vec_dot(shorter, shorter)), square > splat(length * length));
}

#endif
