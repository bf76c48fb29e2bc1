// SPDX-License-Identifier: MIT
// sweep.h -- where collidables will be within the step by their velocities, and when two of them will meet.
//
// This work is based on:
// Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996: conservative advancement. Two shapes that
// are some way apart along a direction cannot meet before the speed along it has closed that distance.
// Paul Firth, Speculative Contacts, 2011: a contact made before bodies meet takes the speed that exceeds the gap.
// Erin Catto, Continuous Collision, GDC 2013: of the speculative points' ghosts, and of a target that is a little inside.
//
// Times and velocities are those of sweep_closing.h.
#ifndef SWEEP_H
#define SWEEP_H
#include "constraints/sweep_closing.h"
#include "stages/manifold.h"

// Looks at a pair while it draws near. Of the fast pairs of the scene tumbler 90 % need one and 1 % more than five; what
// spins by more than a radian a step may need fifteen, and with twelve some went through a wall.
#define SWEEP_ROUNDS 20

// m: pairs meet when they overlap by this much, or else what slides over a seam between two floors would meet the side of
// the second; looked for is twice as much
#define SWEEP_DEPTH (0.5f * LINEAR_SLOP)

// by the velocities with which the step begins
INLINE Advance sweep_advance(const Pools* p, int index)
{
	BodyState body = p->body[index];
	return sweep_advance_of(&p->step, vec(body.vx, body.vy), body.w);
}

INLINE Sweep sweep_of(const Pools* p, WorldShape placed, const GLOBAL Attribute* attribute)
{
	return sweep_with(sweep_advance(p, placed.body), vec(placed.center_x, placed.center_y),
	                  attribute->reach - attribute->radius);
}

INLINE Closing sweep_between(WorldShape a, Sweep sa, WorldShape b, Sweep sb)
{
	return sweep_apart(vec(b.x - a.x, b.y - a.y), sa, sb);
}

INLINE Closing sweep_closing(const Pools* p, WorldShape a, WorldShape b)
{
	Sweep sa = sweep_of(p, a, p->attribute + a.attribute), sb = sweep_of(p, b, p->attribute + b.attribute);
	return sweep_between(a, sa, b, sb);
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
