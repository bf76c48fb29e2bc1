// SPDX-License-Identifier: MIT
// coupling.h -- computes the one coordinate of a gear or a pulley: along = measure of b + ratio * measure of a.
//
// A measure describes the joint frame of a body relative to its base, a frame fixed in the world: the angle over all
// turns, the translation of the anchor along the base's x axis, or the distance of the anchor from the base. Locks,
// limits, springs and motors act on this coordinate as on those of other joints.
//
// This work is based on:
// Erin Catto, Iterative Dynamics with Temporal Coherence, GDC 2005: constraints as Jacobians, one body at a time.
#ifndef COUPLING_H
#define COUPLING_H
#include "constraints/joint_constraint.h"

typedef struct // one side of a coupling
{
	Vec direction;     // derivative of the measure by the body's translation; 0 for an angle
	Real lever, value; // derivative by the angle; change of an angle or translation in the step, or a whole distance
} CouplingSide;

// Computes a side. arm: m, arm of the anchor at the start of the step; line: CouplingMeasure.line.
INLINE CouplingSide coupling_side(const Joint* u, int side, Vec line, Vec arm, const Body* body)
{
	CouplingSide s;
	Vec zero = vec(splat(0.0f), splat(0.0f)), swing = vec_sub(body_displacement(*body, arm), body->d);
	Vec moved = vec_add(body->d, swing);
	Int slides = joint_has(u, JOINT_SLIDES(side)), hoists = joint_has(u, JOINT_HOISTS(side));
	Int turns = (slides | hoists) == 0;
	moved = vec_blend(moved, vec_add(line, moved), hoists);
	s.direction = joint_line(vec_blend(zero, line, slides), moved, hoists);
	s.lever = blend(vec_cross(vec_add(arm, swing), s.direction), splat(1.0f), turns);
	s.value = blend(vec_dot(moved, s.direction), body->da, turns);
	return s;
}

// In lanes with a coupling, replaces value, axis and levers of the joint's coordinate along by those of the coupling.
OUT_OF_LINE void coupling_pose(const Pools* p, int i, const Joint* u, JointPose* c)
{
	if (!p->step.couplings)
		return;
	c->coupled = joint_has(u, JOINT_COUPLED);
	c->couples = lane_bits(c->coupled);
	if (!c->couples)
		return;
	Real zero = splat(0.0f), ratio = load(&joint_rare(p, gear_ratio, i), 0);
	Vec line_a = vec(load(&joint_rare(p, line_a_x, i), 0), load(&joint_rare(p, line_a_y, i), 0));
	Vec line_b = vec(load(&joint_rare(p, line_b_x, i), 0), load(&joint_rare(p, line_b_y, i), 0));
	CouplingSide a = coupling_side(u, 0, line_a, vec(u->arm_a_x, u->arm_a_y), &c->a);
	CouplingSide b = coupling_side(u, 1, line_b, vec(u->arm_b_x, u->arm_b_y), &c->b);
	Real value = load(&joint_rare(p, coupled, i), 0) + (b.value + ratio * a.value);

	// a body whose state is not finite must not affect the other body
	Int sound = c->coupled & (absolute(value + (a.lever + b.lever)) <= splat(MOST_FLOAT));
	Vec none = vec(zero, zero);
	c->axis_a = vec_blend(none, vec_scale(-ratio, a.direction), sound);
	c->axis[0] = vec_blend(c->axis[0], vec_blend(none, b.direction, sound), c->coupled);
	c->lever_a[0] = blend(c->lever_a[0], only(-ratio * a.lever, sound), c->coupled);
	c->lever_b[0] = blend(c->lever_b[0], only(b.lever, sound), c->coupled);
	c->value[0] = blend(c->value[0], only(value, sound), c->coupled);
	c->given_a = vec(load(&joint_rare(p, given_a_x, i), 0), load(&joint_rare(p, given_a_y, i), 0));
}

INLINE void coupling_store(const Pools* p, int i, const JointPose* c)
{
	if (!c->couples)
		return;
	store(&joint_rare(p, given_a_x, i), 0, c->given_a.x);
	store(&joint_rare(p, given_a_y, i), 0, c->given_a.y);
}

// Returns the lanes with a coupling that measures the angle of body b. Impulses of such a coupling are angular, N m s.
INLINE Int coupling_turns(const Joint* u) { return joint_has(u, JOINT_COUPLED) & (joint_has(u, JOINT_LINEAR(1)) == 0); }

#endif
