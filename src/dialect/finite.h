// SPDX-License-Identifier: MIT
// finite.h -- keeps state finite: NaN is never stored, and sums of the user's values are clamped to the finite numbers.
// Devices agree on which results are NaN, but not on the sign and the payload of a NaN (docs/determinism.md).
#ifndef FINITE_H
#define FINITE_H
#include "dialect/vec.h"

#define MOST_FLOAT    3.40282347e38f
#define MOST_IMPULSE  1.0e35f // N s: the momentum of the heaviest body (1e30 kg) at the highest max_speed
#define MOST_FRICTION 1.0e3f  // maximum friction of two surfaces; its product with MOST_IMPULSE is still finite

// Clamps x to -most .. most; NaN stays NaN.
INLINE Real within(Real x, Real most) { return maximum(minimum(x, most), -most); }

// Returns x, or the largest finite number with the sign of x if x is infinite; for sums of values of the user.
INLINE float finite_or_most(float x) { return x > MOST_FLOAT ? MOST_FLOAT : x < -MOST_FLOAT ? -MOST_FLOAT : x; }

// Returns x, or zero if x is NaN.
INLINE Real number_of(Real x) { return blend(splat(0.0f), x, x == x); }

// Clamps x to the finite numbers; returns zero if x is NaN.
INLINE Real finite_of(Real x) { return number_of(within(x, splat(MOST_FLOAT))); }

// Returns x if it is the impulse of a push, otherwise zero: if x is a pull, NaN or more than MOST_IMPULSE. Thus a body
// with a NaN velocity pushes no other body, and is the only one that is frozen. The result is never a negative zero.
INLINE Real push_of(Real x) { return blend(splat(0.0f), x, (x > splat(0.0f)) & (x <= splat(MOST_IMPULSE))); }

// Clamps an impulse to -limit .. limit; limit is finite. NaN becomes -limit.
INLINE Real grip_of(Real x, Real limit) { return minimum(limit, maximum(-limit, x)); }

// Returns the factor that reduces a vector to `length`; 1 if the vector is not longer than that. Vectors whose square
// may overflow are scaled down first. The product of a vector that is not finite and this factor is NaN.
INLINE Real vec_shrink(Vec v, float length)
{
	Real square = vec_dot(v, v);
	Real unit = blend(splat(1.0f), splat(1.35525272e-20f), square > splat(1.0e36f)); // 2^-66
	Vec shorter = vec_scale(unit, v);
	return blend(splat(1.0f), quotient(unit * length, root(vec_dot(shorter, shorter))),
	             square > splat(length * length));
}

#endif
