// SPDX-License-Identifier: MIT
// vec.h -- computes with vectors and rotations of the plane.
#ifndef VEC_H
#define VEC_H
#include "dialect/dialect.h"

typedef struct
{
	Real x, y;
} Vec;

INLINE Vec vec(Real x, Real y)
{
	Vec v;
	v.x = x;
	v.y = y;
	return v;
}
INLINE Vec vec_add(Vec a, Vec b) { return vec(a.x + b.x, a.y + b.y); }
INLINE Vec vec_sub(Vec a, Vec b) { return vec(a.x - b.x, a.y - b.y); }
INLINE Vec vec_scale(Real s, Vec a) { return vec(s * a.x, s * a.y); }
INLINE Vec vec_neg(Vec a) { return vec(-a.x, -a.y); }
INLINE Real vec_dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
INLINE Real vec_cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
// Returns the velocity of a point at arm r on a body with the angular velocity w.
INLINE Vec vec_spin(Real w, Vec r) { return vec(-w * r.y, w * r.x); }
// Rotates a vector; q is a rotation (cos, sin).
INLINE Vec vec_turn(Vec q, Vec a) { return vec(q.x * a.x - q.y * a.y, q.y * a.x + q.x * a.y); }
INLINE Vec vec_turn_back(Vec q, Vec a) { return vec(q.x * a.x + q.y * a.y, q.x * a.y - q.y * a.x); }
INLINE Vec vec_blend(Vec a, Vec b, Int c) { return vec(blend(a.x, b.x, c), blend(a.y, b.y, c)); }

#define UNIT_ULPS 2048

// Returns quotient(1, square_root(square)), the factor that makes the length of a vector 1. If `square` is UNIT_ULPS
// floats from 1 or less, both roundings together are this function of its bits, which takes fewer cycles.
INLINE Real unit_factor(Real square)
{
	Int one = real_bits(splat(1.0f)), ulps = real_bits(square) - one;
	Int above = -(ulps & ~1), below = (3 - ulps) >> 2, far = (ulps < -UNIT_ULPS) | (ulps > UNIT_ULPS);
	Real factor = bits_real(one + blend_int(below, above, above < below));
	return lane_bits(far) ? blend(factor, quotient(splat(1.0f), root(square)), far) : factor;
}

// Returns cosine and sine of an angle up to pi, by a Taylor series for a quarter of the angle; this quarter is then
// doubled twice. The error is below 2e-7 up to 1 radian, which is 60 rad/s at 60 steps per second, and 2.3e-5 at pi.
INLINE Vec vec_rotation(Real angle)
{
	Real a = 0.25f * angle, q = a * a;
	Real s = a * (1.0f - q * (1.0f / 6.0f) * (1.0f - q * (1.0f / 20.0f) * (1.0f - q * (1.0f / 42.0f))));
	Real c = 1.0f - q * 0.5f * (1.0f - q * (1.0f / 12.0f) * (1.0f - q * (1.0f / 30.0f)));
	for (int k = 0; k < 2; ++k)
	{
		Real twice = 2.0f * s * c;
		c = 1.0f - 2.0f * s * s;
		s = twice;
	}
	return vec(c, s);
}

#endif
