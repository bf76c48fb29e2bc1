// SPDX-License-Identifier: MIT
// finite.h -- keeps state finite and normal: neither NaN nor a denormal is stored, and sums of the user's values are
// clamped to the finite numbers.
// Devices agree on which results are NaN, but not on the sign and the payload of a NaN. Some devices flush denormals to
// 0, so values that can lead to one are set to 0 long before (docs/design/determinism.md).
#ifndef FINITE_H
#define FINITE_H
#include "dialect/vec.h"

#define MOST_FLOAT    3.40282347e38f
#define MOST_IMPULSE  1.0e35f // N s: the momentum of the heaviest body (1e30 kg) at the highest max_speed
#define MOST_FRICTION 1.0e3f  // maximum friction of two surfaces; its product with MOST_IMPULSE is still finite

// m/s, rad/s, m, rad, N s, N m s: smaller velocities, motions and impulses count as 0. The product of two larger ones is
// not denormal, and is not lost when masses or rates scale it.
#define TINY 8.67361738e-19f // 2^-60

// Least quotients, squares and energies, in any unit, that count. Adding a denormal to a larger number does not change
// it.
#define ABSORBS 7.88860905e-31f // 2^-100

// m/s: smallest rebound that counts, and smallest threshold of restitution; its square is ABSORBS.
#define ROOT_ABSORBS 8.88178420e-16f // 2^-50

// 1/kg and other units: smaller elements of the matrices of joints count as 0, because they may be divided by others.
#define LEAST_ELEMENT 7.52316385e-37f // 2^-120

// kg: a mass up to this times a denormal velocity is negligible beside an impulse that is not tiny. Contacts of
// heavier bodies set tiny velocities to 0 before they multiply them, which takes 0.3 % more instructions of a CPU; as
// do those of bodies with a moment of inertia above this number, kg m^2.
#define HEAVY_MASS 1.09951163e12f // 2^40

// kg m^2: largest inertia in a step; larger ones, which long arms or the pull of joints require, are reduced to it. The
// product of its inverse and a lever arm is not denormal.
#define MOST_INERTIA 1.26765060e30f // 2^100

// Returns true for NaN and for numbers of at least `least` or, if negative, at most -least. Several lanes compare the
// bits, because integers take 1 cycle and floats 4; and so does OpenCL on a CPU, because PoCL 6 aborts when it compiles
// some kernels that compare the floats (docs/design/opencl.md).
#if defined(CALLS) || LANES > 1
INLINE Int not_below(Real x, float least) { return (real_bits(x) & 0x7fffffff) >= float_bits(least); }
#else
INLINE Int not_below(Real x, float least) { return (absolute(x) < splat(least)) == 0; }
#endif

// Returns x, or 0 if x is below `least`; NaN stays NaN. The result is never a negative zero.
#if LANES == 1 && defined(__SSE2__) && !defined(__OPENCL_C_VERSION__)
typedef float Quad __attribute__((vector_size(16)));
typedef int QuadBits __attribute__((vector_size(16)));

// Flushes in a vector register. For one float, gcc chooses the result in an integer register; finalize took 4 % longer.
INLINE Quad quad_flush(Quad q, float least)
{
	return (Quad)((QuadBits)q & (((QuadBits)q & 0x7fffffff) >= float_bits(least)));
}
INLINE Real flush_below(Real x, float least) { return quad_flush((Quad){x}, least)[0]; }
INLINE Vec vec_flush_tiny(Vec v)
{
	Quad q = quad_flush((Quad){v.x, v.y}, TINY);
	return vec(q[0], q[1]);
}
#else
INLINE Real flush_below(Real x, float least) { return only(x, not_below(x, least)); }
INLINE Vec vec_flush_tiny(Vec v) { return vec(flush_below(v.x, TINY), flush_below(v.y, TINY)); }
#endif
INLINE Real flush_element(Real x) { return flush_below(x, LEAST_ELEMENT); }
INLINE Real flush_tiny(Real x) { return flush_below(x, TINY); }

// Clamps x to -most .. most; NaN stays NaN.
INLINE Real within(Real x, Real most) { return maximum(minimum(x, most), -most); }

// Returns x, or the largest finite number with the sign of x if x is infinite; for sums of values of the user.
INLINE float finite_or_most(float x) { return x > MOST_FLOAT ? MOST_FLOAT : x < -MOST_FLOAT ? -MOST_FLOAT : x; }

// Returns x, or zero if x is NaN.
INLINE Real number_of(Real x) { return only(x, x == x); }

// Clamps x to the finite numbers; returns zero if x is NaN.
INLINE Real finite_of(Real x) { return number_of(within(x, splat(MOST_FLOAT))); }

// Returns x if it is the impulse of a push, otherwise zero: if x is a pull, tiny, NaN or more than MOST_IMPULSE. Thus a
// body with a NaN velocity pushes no other body, and is the only one that is frozen. The result is never a negative
// zero.
INLINE Real push_of(Real x) { return only(x, (x >= splat(TINY)) & (x <= splat(MOST_IMPULSE))); }

// Returns x, an impulse of either sign; 0 if x is tiny, NaN or more than MOST_IMPULSE.
INLINE Real bounded_impulse(Real x)
{
	Real most = absolute(x);
	return only(x, (most >= splat(TINY)) & (most <= splat(MOST_IMPULSE)));
}

// Clamps x to -limit .. limit; NaN becomes -limit.
INLINE Real clamped(Real x, Real limit) { return minimum(limit, maximum(-limit, x)); }

// Clamps an impulse to -limit .. limit; limit is finite and not negative. NaN becomes -limit, a tiny result 0: then x or
// limit is tiny, which a processor finds while it clamps.
INLINE Real grip_of(Real x, Real limit) { return only(clamped(x, limit), not_below(x, TINY) & (limit >= splat(TINY))); }

// Returns a vector with its length reduced to `length`, or unchanged if it is not longer. A vector whose square may
// overflow is scaled down first. A vector that is not finite becomes NaN.
INLINE Vec vec_limit(Vec v, float length)
{
	Real square = vec_dot(v, v);
	Int within_length = square <= splat(length * length);
	if (!lane_bits(within_length == 0))
		return v;
	Vec shorter = vec_scale(blend(splat(1.0f), splat(1.35525272e-20f), square > splat(1.0e36f)), v); // 2^-66
	Real factor = quotient(splat(length), root(vec_dot(shorter, shorter)));
	return vec_blend(vec_scale(factor, shorter), v, within_length);
}

#endif
