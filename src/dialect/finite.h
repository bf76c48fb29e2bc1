// SPDX-License-Identifier: MIT
// finite.h -- functions that keep state finite: NaN is never stored, and sums of the user end at the largest number.
//
// Devices agree on which results are NaN, but not on their sign and payload, so none is stored: docs/determinism.md.
#ifndef FINITE_H
#define FINITE_H
#include "dialect/vec.h"

#define MOST_FLOAT 3.40282347e38f
// N s: the momentum of the heaviest body (1e30 kg) at the highest max_speed
#define MOST_IMPULSE 1.0e35f
// Largest friction of a pair of surfaces: its product with the largest impulse is still finite.
#define MOST_FRICTION 1.0e3f

// Returns x within bounds; NaN stays NaN.
INLINE Real within(Real x, Real most) { return maximum(minimum(x, most), -most); }

// Returns the largest number of its sign in place of an infinity, to store sums of the user.
INLINE float finite_or_most(float x) { return x > MOST_FLOAT ? MOST_FLOAT : x < -MOST_FLOAT ? -MOST_FLOAT : x; }

// Returns zero in place of NaN.
INLINE Real number_of(Real x) { return blend(splat(0.0f), x, x == x); }

// Returns zero in place of NaN, and the largest number of its sign in place of an infinity.
INLINE Real finite_of(Real x) { return number_of(within(x, splat(MOST_FLOAT))); }

// Returns an impulse that pushes: zero if it would pull, is NaN or exceeds MOST_IMPULSE. Thus a body with a NaN
// velocity pushes no other body and is the only one to be frozen; and no zero is negative.
INLINE Real push_of(Real x) { return blend(splat(0.0f), x, (x > splat(0.0f)) & (x <= splat(MOST_IMPULSE))); }

// Returns an impulse within a finite limit on either side; NaN becomes the limit.
INLINE Real grip_of(Real x, Real limit) { return minimum(limit, maximum(-limit, x)); }

// Returns the factor that limits a vector to some length: 1 if it is shorter. The square of a long vector is not
// finite; a vector that is not finite becomes NaN.
INLINE Real vec_shrink(Vec v, float length)
{
	Real square = vec_dot(v, v);
	Real unit = blend(splat(1.0f), splat(1.35525272e-20f), square > splat(1.0e36f)); // 2^-66
	Vec shorter = vec_scale(unit, v);
	return blend(splat(1.0f), unit * length / root(vec_dot(shorter, shorter)), square > splat(length * length));
}

#endif
