// SPDX-License-Identifier: MIT
// sweep.h -- where collidables will be within the step by their velocities, and when two of them will meet.
//
// This work is based on:
// Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996: conservative advancement. Two shapes that
// are some way apart along a direction cannot meet before the speed along it has closed that distance.
// Paul Firth, Speculative Contacts, 2011: a contact made before bodies meet takes the speed that exceeds the gap.
// Erin Catto, Continuous Collision, GDC 2013: of the speculative points' ghosts, and of a target that is a little inside.
//
// Time is a share of the step, from 0 to 1, and so velocities are metres and radians a step.
#ifndef SWEEP_H
#define SWEEP_H
#include "stages/finite.h"
#include "stages/manifold.h"
#include "stages/rolling.h"

// Looks at a pair while it draws near. Of the fast pairs of the scene tumbler 90 % need one and 1 % more than five; what
// spins by more than a radian a step may need fifteen, and with twelve some went through a wall.
#define SWEEP_ROUNDS 20

// m: pairs meet when they overlap by this much, or else what slides over a seam between two floors would meet the side of
// the second; looked for is twice as much
#define SWEEP_DEPTH (0.5f * LINEAR_SLOP)

// m a step: what moves less, or draws near by less, is as good as at rest
#define SWEEP_REST (0.03f * LINEAR_SLOP)

// m a step: what is under load and draws near by less keeps its manifold; faster, arms that lag behind would cost angular
// momentum
#define SWEEP_HOLD LINEAR_SLOP

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

// a velocity no faster than max_speed; what is not finite will be frozen, where it is
INLINE Vec sweep_velocity(const Step* step, Vec v)
{
	if (vec_dot(v, v) <= step->max_speed * step->max_speed)
		return v;
	v = vec_scale(vec_shrink(v, step->max_speed), v);
	return vec(number_of(v.x), number_of(v.y));
}

// by the velocities with which the step begins
INLINE Advance sweep_advance(const Pools* p, int index)
{
	BodyState body = p->body[index];
	Advance advance;
	advance.path = vec_scale(p->step.dt, sweep_velocity(&p->step, vec(body.vx, body.vy)));
	advance.turn = p->step.dt * grip_of(body.w, p->step.max_spin);
	return advance;
}

INLINE Sweep sweep_of(const Pools* p, Placed placed, const GLOBAL Attribute* attribute)
{
	Advance advance = sweep_advance(p, placed.body);
	Sweep s;
	s.path = advance.path;
	s.turn = advance.turn;
	s.center = vec(placed.center_x, placed.center_y);
	s.reach = attribute->reach - attribute->radius + absolute(s.center.x) + absolute(s.center.y);
	return s;
}

INLINE Closing sweep_between(Placed a, Sweep sa, Placed b, Sweep sb)
{
	Vec arm = vec(b.x - a.x + (sb.center.x - sa.center.x), b.y - a.y + (sb.center.y - sa.center.y));
	Vec apart = vec_sub(sb.path, sa.path);
	Real frame = sb.reach < sa.reach ? sa.turn : sb.turn;
	Closing c;
	c.a = sa;
	c.b = sb;
	c.near = vec_sub(apart, vec_spin(frame, arm));
	c.bend = vec_neg(vec_spin(frame, apart));
	c.swing = absolute(sb.turn - sa.turn) * minimum(sa.reach, sb.reach);
	c.most = absolute(c.near.x) + absolute(c.near.y) + c.swing;
	return c;
}

INLINE Closing sweep_closing(const Pools* p, Placed a, Placed b)
{
	Sweep sa = sweep_of(p, a, p->attribute + a.attribute), sb = sweep_of(p, b, p->attribute + b.attribute);
	return sweep_between(a, sa, b, sb);
}

// At most how far any two points of the pair may draw near, by less work than sweep_closing.
INLINE Real sweep_most(const Pools* p, Placed a, Placed b, Real reach_a, Real reach_b)
{
	BodyState ba = p->body[a.body], bb = p->body[b.body];
	Real arm_a = reach_a + absolute(a.center_x) + absolute(a.center_y);
	Real arm_b = reach_b + absolute(b.center_x) + absolute(b.center_y);
	return p->step.dt *
	       (absolute(bb.vx - ba.vx) + absolute(bb.vy - ba.vy) + absolute(ba.w) * arm_a + absolute(bb.w) * arm_b);
}

// how fast any two points of the pair may draw near along a normal from a to b, m
INLINE Real sweep_speed(Closing c, Vec normal, Real time)
{
	return c.swing - vec_dot(normal, vec_add(c.near, vec_scale(time, c.bend)));
}

// Of points at a time, in the frame of a, whose axes are turned by a rotation.
INLINE Reach sweep_reach(Closing c, Vec axes, Real time)
{
	Reach r = reach_of(SPECULATIVE_DISTANCE);
	r.near = vec_scale(1.0f - time, vec_turn_back(axes, vec_add(c.near, vec_scale(time, c.bend))));
	r.swing = (1.0f - time) * c.swing;
	return r;
}

// Rotation of a since the step began, at a time; b in the frame of a then goes to f.
INLINE Vec sweep_frame(Placed a, Placed b, Closing c, Real time, Frame* f)
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
