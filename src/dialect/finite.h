// SPDX-License-Identifier: MIT
// finite.h -- what keeps state finite: NaN is never stored, and what the user drove beyond a float is marked until finalize.
//
// Devices agree on which results are NaN, but not on the sign and the rest of its bits, so a NaN that is stored is a
// difference. docs/determinism.md has the rule and, stage by stage, how it is kept.
#ifndef FINITE_H
#define FINITE_H
#include "dialect/vec.h"

#define MOST_FLOAT 3.40282347e38f
// A velocity, force or torque that the user's calls drove beyond a float, whichever way: finalize freezes the body.
#define LOST bits_float(0x7f800000)
// N s: the momentum of the heaviest body (1e30 kg) at the highest max_speed
#define MOST_IMPULSE 1.0e35f
// of a pair of surfaces: times the largest impulse it is still finite
#define MOST_FRICTION 1.0e3f

// x within bounds; NaN stays
INLINE Real within(Real x, Real most) { return maximum(minimum(x, most), -most); }

// What is stored of the user's sums: all that is not finite has the same bits.
INLINE float finite_or_lost(float x) { return x >= -MOST_FLOAT && x <= MOST_FLOAT ? x : LOST; }

// Nothing in place of NaN.
INLINE Real number_of(Real x) { return choose(splat(0.0f), x, x == x); }

// Infinity into NaN, which no limit makes finite again.
INLINE Real no_infinity(Real x) { return x + (x - x); }

// An impulse that pushes: none when it would pull, is no number or is beyond all bounds. So a body whose velocity is no
// number pushes nobody, and is the only one to be frozen; and no zero is negative.
INLINE Real push_of(Real x) { return choose(splat(0.0f), x, (x > splat(0.0f)) & (x <= splat(MOST_IMPULSE))); }

// An impulse within a limit on either side, which is finite; what is no number becomes the limit.
INLINE Real grip_of(Real x, Real limit) { return minimum(limit, maximum(-limit, x)); }

// What to scale a vector by, to be no longer than some length: 1 when it is not. The square of a long one is not finite; a
// vector that is not finite becomes NaN.
INLINE Real vec_shrink(Vec v, float length)
{
	Real square = vec_dot(v, v);
	Real unit = choose(splat(1.0f), splat(1.35525272e-20f), square > splat(1.0e36f)); // 2^-66
	Vec shorter = vec_scale(unit, v);
	return choose(splat(1.0f), unit * length / root(vec_dot(shorter, shorter)), square > splat(length * length));
}

#endif
