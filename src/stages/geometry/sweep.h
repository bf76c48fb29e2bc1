// SPDX-License-Identifier: MIT
// sweep.h -- computes poses of collidables within the step from their velocities, and bounds of meeting times.
//
// This work is based on:
// Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996: conservative advancement.
// Paul Firth, Speculative Contacts, 2011: a contact before bodies meet removes the speed that exceeds the gap.
// Erin Catto, Continuous Collision, GDC 2013: ghost collisions of speculative points, a target inside the surface.
//
// Times are fractions of the step, velocities are per step, as in sweep_closing.h.
#ifndef SWEEP_H
#define SWEEP_H
#include "constraints/sweep_closing.h"
#include "stages/geometry/manifold.h"

// Maximum number of rounds of conservative advancement. In the scene tumbler, 90 % of the fast pairs need one, and 1 %
// need over five. A pair that spins by over a radian per step may need 15; with 12, some went through a wall.
#define SWEEP_ROUNDS 20

// m: overlap at which a pair counts as meeting. With 0, a body that slides over a seam between two floors would meet
// the side of the second one. The iteration aims at twice this depth.
#define SWEEP_DEPTH (0.5f * LINEAR_SLOP)

// Returns the motion of a body in the step, from its velocity at the start of the step.
INLINE Advance sweep_advance(const Pools* p, int index)
{
	BodyState body = p->body[index];
	return sweep_advance_of(&p->step, vec(body.vx, body.vy), body.w);
}

INLINE Sweep sweep_of(const Pools* p, WorldShape world_shape, const GLOBAL Attribute* attribute)
{
	return sweep_with(sweep_advance(p, world_shape.body), vec(world_shape.center_x, world_shape.center_y),
	                  attribute->reach - attribute->radius);
}

INLINE Closing sweep_between(WorldShape a, Sweep sa, WorldShape b, Sweep sb)
{
	return sweep_apart(vec(b.x - a.x, b.y - a.y), sa, sb);
}

INLINE_LONG Closing sweep_closing(const Pools* p, WorldShape a, WorldShape b, Int moved)
{
	Sweep sa = sweep_of(p, a, p->attribute + a.attribute), sb = sweep_of(p, b, p->attribute + b.attribute);
	Closing closing = sweep_between(a, sa, b, sb);
	sweep_fine(p, &closing, moved, a.body);
	return closing;
}

// m per step: Returns an upper bound of the speed at which two points of the pair approach. normal: from shape a to b.
INLINE Real sweep_speed(Closing c, Vec normal, Real time)
{
	return c.swing - vec_dot(normal, vec_add(c.near, vec_scale(time, c.bend)));
}

// Returns the maximum separation of contact points at `time`, in the frame of shape a. axes: rotation of shape a.
INLINE Reach sweep_reach(Closing c, Vec axes, Real time)
{
	Reach r = reach_of(c.within);
	r.near = vec_scale(1.0f - time, vec_turn_back(axes, vec_add(c.near, vec_scale(time, c.bend))));
	r.swing = (1.0f - time) * c.swing;
	return r;
}

// Returns the rotation of shape a in the step up to a time. *f: pose of shape b in the frame of shape a at that time.
INLINE Vec sweep_frame(WorldShape a, WorldShape b, Closing c, Real time, Frame* f)
{
	Sweep sa = c.a, sb = c.b;
	Vec turn_a = vec_rotation(time * sa.turn), turn_b = vec_rotation(time * sb.turn);
	Vec moved_a = vec_add(vec_scale(time, sa.path), vec_sub(sa.center, vec_turn(turn_a, sa.center)));
	Vec moved_b = vec_add(vec_scale(time, sb.path), vec_sub(sb.center, vec_turn(turn_b, sb.center)));
	Vec from_a = vec_add(vec(b.x - a.x, b.y - a.y), vec_sub(moved_b, moved_a));
	Vec rotation_a = vec_turn(turn_a, vec(a.c, a.s));
	f->position = vec_turn_back(rotation_a, from_a);
	f->rotation = vec_turn_back(rotation_a, vec_turn(turn_b, vec(b.c, b.s)));
	return turn_a;
}

#endif
