// SPDX-License-Identifier: MIT
// chain.h -- a pass over a chain: joints in a row whose locks are solved together, exactly (chain_solve.h).
//
// A rope that carries a hundred times the mass of a link needs hundreds of passes from joint to joint until the links know of
// the load. The host finds such rows of joints (src/world/chains.c); they have no color and come before the colors of a pass.
//
// Stiff axes. A link under tension is like a string: its sideways vibration may be faster than substeps can follow, and the rope
// whips apart. So the chain sees a link's inertia enlarged by what the tension adds to it in an implicit integration, where it
// exceeds the link's own.
//
// This work is based on:
// Sheldon Andrews, Marek Teichmann, Jozsef Kovecses, Geometric Stiffness for Real-time Constrained Multibody Dynamics, 2017.
#ifndef CHAIN_H
#define CHAIN_H
#include "constraints/kinds.h"
#include "stages/chain_solve.h"

typedef struct // a joint of a chain, with its bodies, in registers
{
	Joint u;
	JointPose c;
	int ia, ib;
} ChainLink;

INLINE ChainLink chain_load(const Pools* p, int place)
{
	ChainLink link;
	link.ia = joint_row(p, body_a, place);
	link.ib = joint_row(p, body_b, place);
	joint_load(p, place, PASS_BIAS, &link.u);
	Body a = body_gather(p, link.ia), b = body_gather(p, link.ib);
	link.c = joint_pose(&link.u, &a, &b);
	return link;
}

// The same with the inertias that the chain sees, which are those of the whole step.
INLINE ChainLink chain_link(const Pools* p, int place, const GLOBAL ChainJoint* joint)
{
	ChainLink link = chain_load(p, place);
	link.c.a.inv_inertia = joint->inv_inertia_a;
	link.c.b.inv_inertia = joint->inv_inertia_b;
	return link;
}

INLINE void chain_store(const Pools* p, int place, const ChainLink* link)
{
	joint_store(p, place, PASS_BIAS, &link->u);
	body_scatter(p, link->ia, link->c.a);
	body_scatter(p, link->ib, link->c.b);
}

// Which side of a joint the body is on that it shares with a neighbor: 0 for a, 1 for b, -1 for none that can move.
INLINE int chain_side(const Pools* p, int place, int neighbor)
{
	int na = joint_row(p, body_a, neighbor), nb = joint_row(p, body_b, neighbor);
	for (int side = 0; side < 2; ++side)
	{
		int body = side ? joint_row(p, body_b, place) : joint_row(p, body_a, place);
		if (p->body[body].inv_mass > 0.0f && (body == na || body == nb))
			return side;
	}
	return -1;
}

// ---------------------------------------------------------------------------------------------------------------
// the start of a step: tension
// ---------------------------------------------------------------------------------------------------------------

// kg m^2: what the pull of a joint adds to the inertia of its bodies
INLINE void chain_tension(const Pools* p, int place, GLOBAL ChainJoint* joint)
{
	ChainLink link = chain_load(p, place);
	float sum[JOINT_COORDINATES];
	joint_sums(p, place, &link.u, sum);
	Vec push = joint_impulse(&link.c, sum[0], sum[1], 0.0f).push;
	joint->tension_a = -p->step.h * vec_dot(link.c.arm_a, push);
	joint->tension_b = p->step.h * vec_dot(link.c.arm_b, push);
}

// The tension at a side of joint k, with that of the neighbor that shares its body.
INLINE float chain_pull(const Pools* p, const GLOBAL ChainJoint* joint, int first, int k, int side, int count)
{
	float pull = side ? joint[k].tension_b : joint[k].tension_a;
	for (int other = k - 1; other <= k + 1; other += 2)
	{
		if (other < 0 || other >= count || chain_side(p, first + k, first + other) != side)
			continue;
		pull += chain_side(p, first + other, first + k) ? joint[other].tension_b : joint[other].tension_a;
	}
	return pull;
}

// The inverse inertia of a body with the tension of its joints, where that exceeds its inertia.
INLINE float chain_inertia(float inverse, float tension)
{
	float more = inverse > 0.0f ? tension - 1.0f / inverse : 0.0f;
	return more > 0.0f && more <= MOST_FLOAT ? 1.0f / tension : inverse;
}

INLINE void chain_stiffen(const Pools* p, int first, int k, int count, GLOBAL ChainJoint* joint)
{
	int place = first + k, a = joint_row(p, body_a, place), b = joint_row(p, body_b, place);
	float pull_a = chain_pull(p, joint, first, k, 0, count), pull_b = chain_pull(p, joint, first, k, 1, count);
	joint[k].inv_inertia_a = chain_inertia(p->body[a].inv_inertia, pull_a);
	joint[k].inv_inertia_b = chain_inertia(p->body[b].inv_inertia, pull_b);
}

// ---------------------------------------------------------------------------------------------------------------
// a pass
// ---------------------------------------------------------------------------------------------------------------

// What does not depend on the other joints of the chain: warm start; what turned arms are worth; limits, springs, motors.
INLINE void chain_own(const Pools* p, int place, int pass, const GLOBAL ChainJoint* joint)
{
	ChainLink link = chain_link(p, place, joint);
	if (pass == PASS_WARM_START)
		joint_warm(p, place, &link.u, &link.c);
	if (pass == PASS_BIAS)
		joint_turn(p, place, &link.u, &link.c);
	for (int k = 0; k < JOINT_COORDINATES && pass != PASS_WARM_START; ++k)
		if (joint_drives(p, &link.u, k))
			joint_drive(p, place, k, pass == PASS_BIAS, &link.u, &link.c);
	chain_store(p, place, &link);
}

// What couples joint k with the joint before it: the velocities that impulses along the coordinates of that one cause along
// those of this one, through their common body.
INLINE void chain_couple(const Pools* p, int first, int k, const JointSystem* s, const JointPose* c,
                         GLOBAL ChainJoint* joint)
{
	GLOBAL ChainJoint* to = joint + k;
	int place = first + k, side = k > 0 ? chain_side(p, place, place - 1) : -1;
	for (int n = 0; n < 9; ++n)
		to->l[n] = 0.0f;
	if (side < 0)
		return;
	ChainLink before = chain_link(p, place - 1, joint + k - 1);
	int other = chain_side(p, place - 1, place);
	float inverse = side ? c->b.inv_mass : c->a.inv_mass, turning = side ? c->b.inv_inertia : c->a.inv_inertia;
	float sign = side == other ? 1.0f : -1.0f;
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j)
		{
			if (!s->locked[i] || !joint_has(&before.u, JOINT_LOCKED(j)))
				continue;
			float lever = i == JOINT_ANGLE ? 1.0f : side ? c->lever_b[i] : c->lever_a[i];
			float across = j == JOINT_ANGLE ? 1.0f : other ? before.c.lever_b[j] : before.c.lever_a[j];
			float along = i == JOINT_ANGLE || j == JOINT_ANGLE ? 0.0f : vec_dot(c->axis[i], before.c.axis[j]);
			to->l[3 * i + j] = sign * (inverse * along + turning * lever * across);
		}
}

// Where joints hold a body twice over, as in a welded bridge, the system has no single solution. A little more on the diagonal
// picks the smallest; since it multiplies changes of impulses only, it does not make the chain softer.
#define CHAIN_GIVE 1.00001f

// The equations of joint k: diagonal block, right side, coupling.
INLINE void chain_build(const Pools* p, int first, int k, int pass, GLOBAL ChainJoint* joint)
{
	GLOBAL ChainJoint* to = joint + k;
	ChainLink link = chain_link(p, first + k, to);
	JointSystem s = joint_system(p, pass == PASS_BIAS, &link.u, &link.c);
	to->d[0] = CHAIN_GIVE * s.yield[0];
	to->d[1] = s.cross[0];
	to->d[2] = s.cross[1];
	to->d[3] = CHAIN_GIVE * s.yield[1];
	to->d[4] = s.cross[2];
	to->d[5] = CHAIN_GIVE * s.yield[2];
	for (int i = 0; i < 3; ++i)
		to->r[i] = s.goal[i];
	chain_couple(p, first, k, &s, &link.c, joint);
}

// Gives the bodies of a joint the impulses of the solution.
INLINE void chain_give(const Pools* p, int place, int pass, const GLOBAL ChainJoint* joint)
{
	ChainLink link = chain_link(p, place, joint);
	float x[3] = {joint->x[0], joint->x[1], joint->x[2]};
	joint_hold(&link.u, &link.c, x);
	if (pass == PASS_RELAX && p->step.drives)
		joint_peak(p, place, &link.u);
	chain_store(p, place, &link);
}

// Item i is a chain, argument the pass. Neighbors share bodies, so even joints come first, then odd ones.
GROUP_STAGE(chain)
{
	int pass = p->argument, count = p->chain[i].y;
	int first = p->counters->layout[CONSTRAINT_JOINT].begin[COLORS] + p->chain[i].x;
	GLOBAL ChainJoint* joint = p->chain_joint + p->chain[i].x;
	(void)bench;
	if (pass == PASS_BOUNCE)
		return;
	if (pass == PASS_WARM_START)
	{
		for (int k = group_lane(); k < count; k += group_width())
			chain_tension(p, first + k, joint + k);
		group_meet();
		for (int k = group_lane(); k < count; k += group_width())
			chain_stiffen(p, first, k, count, joint);
		group_meet();
	}
	for (int odd = 0; odd < 2; ++odd)
	{
		for (int k = 2 * group_lane() + odd; k < count; k += 2 * group_width())
			chain_own(p, first + k, pass, joint + k);
		group_meet();
	}
	if (pass == PASS_WARM_START)
		return;
	for (int k = group_lane(); k < count; k += group_width())
		chain_build(p, first, k, pass, joint);
	chain_solve(joint, count);
	for (int odd = 0; odd < 2; ++odd)
	{
		for (int k = 2 * group_lane() + odd; k < count; k += 2 * group_width())
			chain_give(p, first + k, pass, joint + k);
		group_meet();
	}
}

#endif
