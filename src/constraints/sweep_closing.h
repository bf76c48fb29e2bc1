// SPDX-License-Identifier: MIT
// sweep_closing.h -- computes the approach of two collidables within the step, from their velocities.
// Time is a share of the step, from 0 to 1, so velocities are in meters and radians per step.
#ifndef SWEEP_CLOSING_H
#define SWEEP_CLOSING_H
#include "constraints/bay_gravity.h"
#include "dialect/finite.h"

#define SWEEP_REST (0.03f * LINEAR_SLOP) // m per step: motions and approaches slower than this count as rest
#define SWEEP_SLOP LINEAR_SLOP // m per step: a loaded pair that approaches more slowly than this keeps its manifold

// m per step: a loaded pair that slides faster than this does not keep its manifold. If it slides more slowly, but
// sliding plus rotation times reach is more than this, its arms are turned with the bodies. Arms that do not turn would
// lose angular momentum, and let bodies that turn with a drum overlap.
#define SWEEP_LAG (0.3f * LINEAR_SLOP)

typedef struct // motion of a body until the end of the step
{
	Vec path;  // m
	Real turn; // rad
} Advance;

typedef struct // motion of a collidable with its body
{
	Vec path;   // path of the center of mass, m
	Vec center; // current offset from the origin of the collidable to the center of mass, m
	Real turn;  // rad
	Real reach; // m: distance of the farthest point of the core from the center of mass
} Sweep;

typedef struct // motion of collidable b relative to collidable a
{
	Sweep a, b;
	Vec near;    // m: velocity of the center of b relative to that of a, in a frame that turns with the larger one
	Vec bend;    // m: change of `near` during the step
	Real swing;  // m: upper bound of the additional speed of other points of the smaller collidable
	Real most;   // m: upper bound of the approach of any two points of the pair
	Real grain;  // factor of the tolerances of the pair
	Real within; // m: the pair has points if its separation is smaller than this
} Closing;

RARE Real sweep_halves(Int moved)
{
	Real grain = splat(1.0f);
	for (int level = 0; level < GRAIN_LEVELS; ++level)
		grain = blend(grain, 0.5f * grain, (moved & (COLLIDABLE_GRAIN << level)) != 0);
	return grain;
}

// Returns the factor of the tolerances of a pair. moved: COLLIDABLE_* bits of both collidables.
INLINE Real sweep_grain(const Step* step, Int moved) { return step->small ? sweep_halves(moved) : splat(1.0f); }

// Returns the factor of the separation below which a pair has points.
INLINE Real sweep_room(const Step* step, Int moved) { return sweep_grain(step, moved >> GRAIN_LEVELS); }

// m: Returns the separation below which a pair has points: SPECULATIVE_DISTANCE, less for small bodies, but at least
// the distance that gravity closes in a step. body: one of the pair, for the gravity of its world.
INLINE Real sweep_within(const Pools* p, Int moved, int body)
{
	if (!p->step.small)
		return splat(SPECULATIVE_DISTANCE);
	return maximum(SPECULATIVE_DISTANCE * sweep_room(&p->step, moved), splat(fall_of(p, body)));
}

// Returns one member of the attributes `shape`, an index per lane. member: address of this member in attribute 0.
INLINE Real sweep_shape(const GLOBAL float* member, Int shape)
{
	return gather(member, shape * (int)(sizeof(Attribute) / sizeof(float)));
}

// Returns the time, in steps, at which the prediction ends: one substep after the end of the step; 1 if dt is 0.
INLINE float sweep_end(const Step* step) { return step->dt > 0.0f ? 1.0f + quotient(step->h, step->dt) : 1.0f; }

// Returns a velocity limited to max_speed; 0 for a velocity that is not finite, because its body will be frozen.
INLINE Vec sweep_velocity(const Step* step, Vec v)
{
	Int slow = vec_dot(v, v) <= splat(step->max_speed * step->max_speed);
	if (!lane_bits(slow == 0))
		return v;
	Vec limited = vec_flush_tiny(vec_limit(v, step->max_speed));
	return vec_blend(vec(number_of(limited.x), number_of(limited.y)), v, slow);
}

INLINE Advance sweep_advance_of(const Step* step, Vec v, Real w)
{
	Advance advance;
	advance.path = vec_scale(splat(step->dt), sweep_velocity(step, v));
	advance.turn = step->dt * clamped(w, splat(step->max_spin));
	return advance;
}

// Returns the motion of a collidable. core, m: distance of the farthest point of the core from the origin.
INLINE Sweep sweep_with(Advance advance, Vec center, Real core)
{
	Sweep s;
	s.path = advance.path;
	s.turn = advance.turn;
	s.center = center;
	s.reach = core + absolute(center.x) + absolute(center.y);
	return s;
}

// Returns the relative motion of a pair. between: m, vector from the origin of a to that of b.
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

// Sets the tolerances of a pair. If one of two fast bodies is stopped within the step, they may meet although they do
// not approach. So the pair has points up to the distance that either body moves, but at most SPECULATIVE_DISTANCE.
// body: as in sweep_within.
INLINE void sweep_fine(const Pools* p, Closing* c, Int moved, int body)
{
	if (!p->step.small)
		return;
	Real way_a = absolute(c->a.path.x) + absolute(c->a.path.y), way_b = absolute(c->b.path.x) + absolute(c->b.path.y);
	c->grain = sweep_grain(&p->step, moved);
	c->within = minimum(maximum(sweep_within(p, moved, body), maximum(way_a, way_b)), splat(SPECULATIVE_DISTANCE));
}

#endif
