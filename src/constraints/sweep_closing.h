// SPDX-License-Identifier: MIT
// sweep_closing.h -- how two collidables draw near each other within the step, by their velocities.
//
// Time is a share of the step, from 0 to 1, and so velocities are metres and radians a step.
#ifndef SWEEP_CLOSING_H
#define SWEEP_CLOSING_H
#include "dialect/finite.h"
#include "pools/pools.h"

// m a step: what moves less, or draws near by less, is as good as at rest
#define SWEEP_REST (0.03f * LINEAR_SLOP)

// m a step: what is under load and draws near by less keeps its manifold
#define SWEEP_HOLD LINEAR_SLOP

// m a step: and that only as long as it slides by less. Where arms turn by more, they are turned along. Arms that lag behind
// cost angular momentum, and let what turns with a drum overlap.
#define SWEEP_LAG (0.3f * LINEAR_SLOP)

typedef struct // of a body until the end of the step
{
	Vec path;  // m
	Real turn; // rad
} Advance;

typedef struct // of a collidable and its body
{
	Vec path;   // of the center of mass, m
	Vec center; // from the collidable to the center of mass, now, m
	Real turn;  // rad
	Real reach; // m: farthest point of the core from the center of mass
} Sweep;

typedef struct // of b against a
{
	Sweep a, b;
	Vec near;   // m: velocity of the center of the smaller one against the larger one, with which it turns
	Vec bend;   // m: how that changes
	Real swing; // m: how much faster another point of it may be
	Real most;  // m: how far any two points of the pair may draw near
} Closing;

// a member of the attributes of shapes, which are indices into that pool; member is that of the first
INLINE Real sweep_shape(const GLOBAL float* member, Int shape)
{
	return gather(member, shape * (int)(sizeof(Attribute) / sizeof(float)));
}

// when the last relaxing pass looks: a substep after the step, which may take no time
INLINE float sweep_end(const Step* step) { return step->dt > 0.0f ? 1.0f + step->h / step->dt : 1.0f; }

// a velocity no faster than max_speed; what is not finite will be frozen, where it is
INLINE Vec sweep_velocity(const Step* step, Vec v)
{
	if (!lane_bits((vec_dot(v, v) <= splat(step->max_speed * step->max_speed)) == 0))
		return v;
	v = vec_scale(vec_shrink(v, step->max_speed), v);
	return vec(number_of(v.x), number_of(v.y));
}

// by the velocities with which the step begins
INLINE Advance sweep_advance_of(const Step* step, Vec v, Real w)
{
	Advance advance;
	advance.path = vec_scale(splat(step->dt), sweep_velocity(step, v));
	advance.turn = step->dt * grip_of(w, splat(step->max_spin));
	return advance;
}

// core: how far the core reaches from the origin of the collidable, m
INLINE Sweep sweep_with(Advance advance, Vec center, Real core)
{
	Sweep s;
	s.path = advance.path;
	s.turn = advance.turn;
	s.center = center;
	s.reach = core + absolute(center.x) + absolute(center.y);
	return s;
}

// between: from the origin of a to that of b, m
INLINE Closing sweep_apart(Vec between, Sweep sa, Sweep sb)
{
	Vec arm = vec(between.x + (sb.center.x - sa.center.x), between.y + (sb.center.y - sa.center.y));
	Vec apart = vec_sub(sb.path, sa.path);
	Real frame = choose(sb.turn, sa.turn, sb.reach < sa.reach);
	Closing c;
	c.a = sa;
	c.b = sb;
	c.near = vec_sub(apart, vec_spin(frame, arm));
	c.bend = vec_neg(vec_spin(frame, apart));
	c.swing = absolute(sb.turn - sa.turn) * minimum(sa.reach, sb.reach);
	c.most = absolute(c.near.x) + absolute(c.near.y) + c.swing;
	return c;
}

#endif
