// SPDX-License-Identifier: MIT
// vec.h -- vectors and rotations of the plane.
#ifndef VEC_H
#define VEC_H
#include "stages/dialect.h"

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
// the velocity of a point at r that turns with w
INLINE Vec vec_spin(Real w, Vec r) { return vec(-w * r.y, w * r.x); }
// q is a rotation (cos, sin)
INLINE Vec vec_turn(Vec q, Vec a) { return vec(q.x * a.x - q.y * a.y, q.y * a.x + q.x * a.y); }
INLINE Vec vec_turn_back(Vec q, Vec a) { return vec(q.x * a.x + q.y * a.y, q.x * a.y - q.y * a.x); }
INLINE Real absolute(Real a) { return choose(a, -a, a < splat(0.0f)); }

#endif
