// SPDX-License-Identifier: MIT
// sweep_closing.h -- how two collidables approach each other within the step, from their velocities.
//
// Time is a share of the step, from 0 to 1, so velocities are in metres and radians per step.
#ifndef SWEEP_CLOSING_H
#define SWEEP_CLOSING_H
#include "dialect/finite.h"
#include "pools/pools.h"

// m per step: a slower motion or approach counts as rest
#define SWEEP_REST (0.03f * LINEAR_SLOP)

// m per step: a loaded pair that approaches more slowly keeps its manifold
#define SWEEP_SLOP LINEAR_SLOP

// m per step: a loaded pair keeps its manifold only while it slides more slowly. If its arms turn by more, they are
// turned with it. Arms that lag behind cost angular momentum, and let bodies that turn with a drum overlap.
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
	Vec near;    // m: velocity of the center of the smaller one against the larger one, with which it turns
	Vec bend;    // m: how that changes
	Real swing;  // m: how much faster another point of it may be
	Real most;   // m: how far any two points of the pair may draw near
	Real grain;  // factor of the tolerances of the pair
	Real within; // m: the separation from which on it has points
} Closing;

// The factor of the tolerances of a pair, from the MOVED_* bits of both sides, in a world with small bodies.
RARE Real sweep_halves(Int moved)
{
	Real grain = splat(1.0f);
	for (int level = 0; level < GRAIN_LEVELS; ++level)
		grain = blend(grain, 0.5f * grain, (moved & (COLLIDABLE_GRAIN << level)) != 0);
	return grain;
}

// The factor of the tolerances of a pair, from the MOVED_* bits of both sides.
INLINE Real sweep_grain(const Step* step, Int moved) { return step->small ? sweep_halves(moved) : splat(1.0f); }

// The same of the distance from which on a pair has points.
INLINE Real sweep_room(const Step* step, Int moved) { return sweep_grain(step, moved >> GRAIN_LEVELS); }

// m: the separation from which on a pair has points: the speculative distance, less for small bodies, but never less than gravity closes
// in a step.
INLINE Real sweep_within(const Step* step, Int moved)
{
	if (!step->small)
		return splat(SPECULATIVE_DISTANCE);
	return maximum(SPECULATIVE_DISTANCE * sweep_room(step, moved), splat(step->fall));
}

// a member of the attributes with these indices; member is that of attribute 0
INLINE Real sweep_shape(const GLOBAL float* member, Int shape)
{
	return gather(member, shape * (int)(sizeof(Attribute) / sizeof(float)));
}

// time of the last relaxing pass: a substep after the step; dt may be 0
INLINE float sweep_end(const Step* step) { return step->dt > 0.0f ? 1.0f + step->h / step->dt : 1.0f; }

// A velocity limited to max_speed; one that is not finite becomes 0, because its body will be frozen.
INLINE Vec sweep_velocity(const Step* step, Vec v)
{
	if (!lane_bits((vec_dot(v, v) <= splat(step->max_speed * step->max_speed)) == 0))
		return v;
	v = vec_scale(vec_shrink(v, step->max_speed), v);
	return vec(number_of(v.x), number_of(v.y));
}

// From the velocities at the beginning of the step.
INLINE Advance sweep_advance_of(const Step* step, Vec v, Real w)
{
	Advance advance;
	advance.path = vec_scale(splat(step->dt), sweep_velocity(step, v));
	advance.turn = step->dt * grip_of(w, splat(step->max_spin));
	return advance;
}

// core: farthest point of the core from the origin of the collidable, m.
INLINE Sweep sweep_with(Advance advance, Vec center, Real core)
{
	Sweep s;
	s.path = advance.path;
	s.turn = advance.turn;
	s.center = center;
	s.reach = core + absolute(center.x) + absolute(center.y);
	return s;
}

// between: from the origin of a to that of b, m.
INLINE Closing sweep_apart(Vec between, Sweep sa, Sweep sb)
{
	Vec arm = vec(between.x + (sb.center.x - sa.center.x), between.y + (sb.center.y - sa.center.y));
	Vec apart = vec_sub(sb.path, sa.path);
	Real frame = blend(sb.turn, sa.turn, sb.reach < sa.reach);
	Closing c;
	c.a = sa;
	c.b = sb;
	c.near = vec_sub(apart, vec_spin(frame, arm));
	c.bend = vec_neg(vec_spin(frame, apart));
	c.swing = absolute(sb.turn - sa.turn) * minimum(sa.reach, sb.reach);
	c.most = absolute(c.near.x) + absolute(c.near.y) + c.swing;
	c.grain = splat(1.0f);
	c.within = splat(SPECULATIVE_DISTANCE);
	return c;
}

// Sets the tolerances of a closing to those of its pair. What stops one of two fast bodies within the step may make them meet, though they do
// not approach: so they have points as far apart as they move.
INLINE void sweep_fine(const Step* step, Closing* c, Int moved)
{
	if (!step->small)
		return;
	Real way_a = absolute(c->a.path.x) + absolute(c->a.path.y), way_b = absolute(c->b.path.x) + absolute(c->b.path.y);
	c->grain = sweep_grain(step, moved);
	c->within = minimum(maximum(sweep_within(step, moved), maximum(way_a, way_b)), splat(SPECULATIVE_DISTANCE));
}

#endif
