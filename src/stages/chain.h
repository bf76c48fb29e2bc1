// SPDX-License-Identifier: MIT
// chain.h -- a pass over a chain: joints in a row whose locks are solved together, exactly (chain_solve.h).
//
// A rope that carries a hundred times the mass of a link needs hundreds of passes from joint to joint until the links know of
// the load. The host finds such rows of joints (src/world/chains.c); they have no color, and come after the colors of a pass.
//
// Stiff axes. A link under tension is like a string: its sideways vibration may be faster than substeps can follow, and the rope
// whips apart. So for the step a link's inertia is enlarged to what the tension makes it in an implicit integration, where that
// exceeds its own. All constraints of the link see the same inertia: otherwise they would take turns in adding energy.
//
// Joints 0, 2, 4, ... of a chain have no bodies in common, nor have 1, 3, 5, ...: each half is a row of places, of which a wide
// pass takes a block at once. Chains of similar lengths lie side by side: a block has one joint of each.
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
	Int ia, ib;
} ChainLink;

// Loops over the spots of one half of a chain: 0 for even joints, 1 for odd ones. A wide pass runs on into inert places.
#define CHAIN_EACH(spot, chain, odd)                                                                         \
	for (int spot = (chain)->first + (odd) * (chain)->odds + group_lane();                                   \
	     spot < (chain)->first + (odd) * (chain)->odds + ((chain)->count + 1 - (odd)) / 2 * (chain)->stride; \
	     spot += group_width())                                                                              \
		if (chain_has(chain, spot))

// Whether there is a chain at a spot, of those that lie side by side.
INLINE int chain_has(const Chain* chain, int spot)
{
	return chain->stride == 1 || (spot & (MAX_LANES - 1)) < chain->lanes;
}

#define CHAIN_PUT(p, member, spot, x) store(&chain_at(p, member, spot), 0, x)

// The rows and the bodies of a joint.
INLINE ChainLink chain_load(const Pools* p, int place)
{
	ChainLink link;
	link.ia = load_int(&joint_row(p, body_a, place), 0);
	link.ib = load_int(&joint_row(p, body_b, place), 0);
	joint_load(p, place, PASS_BIAS, &link.u);
	link.c.a = body_gather(p, link.ia);
	link.c.b = body_gather(p, link.ib);
	return link;
}

// The same with its pose now.
INLINE ChainLink chain_load_posed(const Pools* p, int place)
{
	ChainLink link = chain_load(p, place);
	link.c = joint_pose(&link.u, &link.c.a, &link.c.b);
	return link;
}

// What the end of a pass needs of a pose: impulses are given along the axes of the equations.
INLINE void chain_keep_pose(const Pools* p, int spot, const JointPose* c)
{
	CHAIN_PUT(p, axis[0], spot, c->axis[0].x);
	CHAIN_PUT(p, axis[1], spot, c->axis[0].y);
	for (int k = 0; k < 2; ++k)
	{
		CHAIN_PUT(p, lever_a[k], spot, c->lever_a[k]);
		CHAIN_PUT(p, lever_b[k], spot, c->lever_b[k]);
	}
}

// Inertias of the step lie beside the pose, so that only half of a body's state is gathered.
INLINE ChainLink chain_load_kept(const Pools* p, const Chain* chain, int spot)
{
	ChainLink link = chain_load(p, chain->begin + spot);
	JointPose* c = &link.c;
	c->a.inv_inertia = CHAIN_AT(p, step_a, spot);
	c->b.inv_inertia = CHAIN_AT(p, step_b, spot);
	c->axis[0] = vec(CHAIN_AT(p, axis[0], spot), CHAIN_AT(p, axis[1], spot));
	c->axis[1] = vec(-c->axis[0].y, c->axis[0].x);
	for (int k = 0; k < 2; ++k)
	{
		c->lever_a[k] = CHAIN_AT(p, lever_a[k], spot);
		c->lever_b[k] = CHAIN_AT(p, lever_b[k], spot);
	}
	joint_alone(c);
	return link;
}

INLINE void chain_store(const Pools* p, const Chain* chain, int spot, const ChainLink* link)
{
	joint_store(p, chain->begin + spot, PASS_BIAS, &link->u);
	body_scatter(p, link->ia, link->c.a);
	body_scatter(p, link->ib, link->c.b);
}

// ---------------------------------------------------------------------------------------------------------------
// the start of a step: tension, and which body joints share
// ---------------------------------------------------------------------------------------------------------------

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

// kg m^2: what the pull of a joint adds to the inertia of its bodies
INLINE void chain_tension(const Pools* p, const Chain* chain, int spot)
{
	ChainLink link = chain_load_posed(p, chain->begin + spot);
	Real sum[JOINT_COORDINATES];
	joint_sums(p, chain->begin + spot, &link.u, sum);
	Vec push = joint_impulse(&link.c, sum[0], sum[1], splat(0.0f)).push;
	CHAIN_PUT(p, tension_a, spot, splat(-p->step.h) * vec_dot(link.c.arm_a, push));
	CHAIN_PUT(p, tension_b, spot, splat(p->step.h) * vec_dot(link.c.arm_b, push));
}

INLINE float chain_pull_of(const Pools* p, int spot, int side)
{
	return side ? chain_at(p, tension_b, spot) : chain_at(p, tension_a, spot);
}

// The tension at a side of joint k, with that of the neighbor that shares its body.
INLINE float chain_pull(const Pools* p, const Chain* chain, int k, int side)
{
	int spot = chain_spot(chain, k), place = chain->begin + spot;
	float pull = chain_pull_of(p, spot, side);
	for (int other = k - 1; other <= k + 1; other += 2)
	{
		if (other < 0 || other >= chain->count)
			continue;
		int at = chain_spot(chain, other);
		if (chain_side(p, place, chain->begin + at) == side)
			pull += chain_pull_of(p, at, chain_side(p, chain->begin + at, place));
	}
	return pull;
}

// The inverse inertia of a body with the tension of its joints, where that exceeds its inertia.
INLINE float chain_inertia(float inverse, float tension)
{
	float more = inverse > 0.0f ? tension - 1.0f / inverse : 0.0f;
	return more > 0.0f && more <= MOST_FLOAT ? 1.0f / tension : inverse;
}

// The inertias of a joint's bodies, their own and for the step; and which body it shares with the joint before it.
INLINE void chain_stiffen(const Pools* p, const Chain* chain, int k)
{
	int spot = chain_spot(chain, k), place = chain->begin + spot;
	int before = chain->begin + chain_spot(chain, k > 0 ? k - 1 : 0), side = k > 0 ? chain_side(p, place, before) : -1;
	int a = joint_row(p, body_a, place), b = joint_row(p, body_b, place);
	float own_a = p->body[a].inv_inertia, own_b = p->body[b].inv_inertia;
	float step_a = chain_inertia(own_a, chain_pull(p, chain, k, 0)),
	      step_b = chain_inertia(own_b, chain_pull(p, chain, k, 1));
	chain_at(p, own_a, spot) = own_a;
	chain_at(p, own_b, spot) = own_b;
	chain_at(p, step_a, spot) = step_a;
	chain_at(p, step_b, spot) = step_b;
	chain_at(p, side, spot) = side > 0 ? 1.0f : 0.0f;
	chain_at(p, other, spot) = side >= 0 && chain_side(p, before, place) > 0 ? 1.0f : 0.0f;
	chain_at(p, inv_mass, spot) = side < 0 ? 0.0f : p->body[side ? b : a].inv_mass;
	chain_at(p, turns, spot) = side ? step_b : step_a;
}

// The inert joints at the end of both halves of a chain alone: what is coupled with them stays as it is.
INLINE void chain_clear(const Pools* p, const Chain* chain)
{
	for (int n = part_lane(); n < 2 * chain->odds; n += part_width())
	{
		int odd = n >= chain->odds, spot = chain->first + n;
		if (n - odd * chain->odds < (chain->count + 1 - odd) / 2)
			continue;
		for (int k = 0; k < 9; ++k)
			chain_at(p, l[k], spot) = 0.0f;
		for (int k = 0; k < 6; ++k)
			chain_at(p, d[k], spot) = 0.0f;
		for (int k = 0; k < 3; ++k)
			chain_at(p, r[k], spot) = chain_at(p, x[k], spot) = 0.0f;
		chain_at(p, inv_mass, spot) = 0.0f;
	}
}

// Sets the inertias of a joint's bodies. Two joints set the same of their common body.
INLINE void chain_set_inertias(const Pools* p, int place, float inverse_a, float inverse_b)
{
	if (inverse_a > 0.0f)
		p->body[joint_row(p, body_a, place)].inv_inertia = inverse_a;
	if (inverse_b > 0.0f)
		p->body[joint_row(p, body_b, place)].inv_inertia = inverse_b;
}

// ---------------------------------------------------------------------------------------------------------------
// a pass
// ---------------------------------------------------------------------------------------------------------------

// What does not depend on the other joints of the chain: warm start; what turned arms are worth; limits, springs, motors.
INLINE void chain_own(const Pools* p, const Chain* chain, int spot, int pass)
{
	ChainLink link = chain_load_posed(p, chain->begin + spot);
	int place = chain->begin + spot;
	if (pass == PASS_WARM_START)
		joint_warm(p, place, &link.u, &link.c);
	if (pass == PASS_BIAS)
		joint_turn(p, place, &link.u, &link.c);
	for (int k = 0; k < JOINT_COORDINATES && pass != PASS_WARM_START; ++k)
		if (joint_drives(p, &link.u, k))
			joint_drive(p, place, k, pass == PASS_BIAS, &link.u, &link.c);
	chain_store(p, chain, spot, &link);
}

// Where joints hold a body twice over, as in a welded bridge, the system has no single solution. A little more on the diagonal
// picks the smallest; since it multiplies changes of impulses only, it does not make the chain softer.
#define CHAIN_GIVE 1.00001f

// The equations of a joint: diagonal block, right side; and what couples it with others.
INLINE void chain_build(const Pools* p, const Chain* chain, int spot, int pass)
{
	ChainLink link = chain_load_posed(p, chain->begin + spot);
	chain_keep_pose(p, spot, &link.c);
	JointSystem s = joint_system(p, pass == PASS_BIAS, &link.u, &link.c);
	Real locks = splat(0.0f), holds = splat(0.0f), zero = splat(0.0f);
	CHAIN_PUT(p, d[0], spot, CHAIN_GIVE * s.yield[0]);
	CHAIN_PUT(p, d[1], spot, s.cross[0]);
	CHAIN_PUT(p, d[2], spot, s.cross[1]);
	CHAIN_PUT(p, d[3], spot, CHAIN_GIVE * s.yield[1]);
	CHAIN_PUT(p, d[4], spot, s.cross[2]);
	CHAIN_PUT(p, d[5], spot, CHAIN_GIVE * s.yield[2]);
	for (int k = 0; k < 3; ++k)
	{
		CHAIN_PUT(p, r[k], spot, s.goal[k]);
		locks = locks + choose(zero, splat((float)(1 << k)), joint_has(&link.u, JOINT_LOCKED(k)));
		holds = holds + choose(zero, splat((float)(1 << k)), s.locked[k]);
	}
	CHAIN_PUT(p, locks, spot, locks);
	CHAIN_PUT(p, holds, spot, holds);
}

// A component of the joints before: a block of them begins where chains lie side by side.
#define CHAIN_BEFORE(p, member) (chain->stride > 1 ? CHAIN_AT(p, member, first) : CHAIN_GATHER(p, member, first))

// The velocities that impulses along the coordinates of the joint before cause along those of this one, through their common
// body.
INLINE void chain_couple(const Pools* p, const Chain* chain, int spot, int odd)
{
	Real zero = splat(0.0f), one = splat(1.0f);
	int first = odd ? spot - chain->odds : spot + chain->odds - chain->stride;
	Int right = CHAIN_AT(p, side, spot) > zero, right_there = CHAIN_AT(p, other, spot) > zero;
	Real inverse = CHAIN_AT(p, inv_mass, spot), turning = CHAIN_AT(p, turns, spot);
	Real sign = choose(splat(-1.0f), one, right == right_there), lever[3], across[3];
	Int holds = whole(CHAIN_AT(p, holds, spot)), locks = whole(CHAIN_BEFORE(p, locks));
	Vec axis[2], other[2];
	axis[0] = vec(CHAIN_AT(p, axis[0], spot), CHAIN_AT(p, axis[1], spot));
	other[0] = vec(CHAIN_BEFORE(p, axis[0]), CHAIN_BEFORE(p, axis[1]));
	axis[1] = vec(-axis[0].y, axis[0].x);
	other[1] = vec(-other[0].y, other[0].x);
	for (int k = 0; k < 2; ++k)
	{
		lever[k] = choose(CHAIN_AT(p, lever_a[k], spot), CHAIN_AT(p, lever_b[k], spot), right);
		across[k] = choose(CHAIN_BEFORE(p, lever_a[k]), CHAIN_BEFORE(p, lever_b[k]), right_there);
	}
	lever[JOINT_ANGLE] = across[JOINT_ANGLE] = one;
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j)
		{
			Int wanted = (inverse > zero) & ((holds & (1 << i)) != 0) & ((locks & (1 << j)) != 0);
			Real along = i == JOINT_ANGLE || j == JOINT_ANGLE ? zero : vec_dot(axis[i & 1], other[j & 1]);
			Real value = sign * (inverse * along + turning * lever[i] * across[j]);
			CHAIN_PUT(p, l[3 * i + j], spot, choose(zero, value, wanted));
		}
}

// Gives the bodies of a joint the impulses of the solution.
INLINE void chain_give(const Pools* p, const Chain* chain, int spot, int pass)
{
	ChainLink link = chain_load_kept(p, chain, spot);
	Real x[3] = {CHAIN_AT(p, x[0], spot), CHAIN_AT(p, x[1], spot), CHAIN_AT(p, x[2], spot)};
	joint_hold(&link.u, &link.c, x);
	if (pass == PASS_RELAX && p->step.drives)
		joint_peak(p, chain->begin + spot, &link.u);
	chain_store(p, chain, spot, &link);
}

// One of chains side by side.
INLINE Chain chain_lane(const Chain* chain, int lane)
{
	Chain one = *chain;
	one.first += lane;
	return one;
}

INLINE void chain_begin(const Pools* p, const Chain* chain)
{
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(spot, chain, odd)
	chain_tension(p, chain, spot);
	if (chain->stride == 1)
		chain_clear(p, chain);
	group_meet();
	for (int k = part_lane(); k < chain->count * chain->lanes; k += part_width())
	{
		Chain one = chain_lane(chain, k % chain->lanes);
		chain_stiffen(p, &one, k / chain->lanes);
	}
	group_meet();
	for (int k = part_lane(); k < chain->count * chain->lanes; k += part_width())
	{
		int spot = chain_spot_of(chain, k);
		chain_set_inertias(p, chain->begin + spot, chain_at(p, step_a, spot), chain_at(p, step_b, spot));
	}
	group_meet();
}

INLINE void chain_locks(const Pools* p, const Chain* chain, int pass)
{
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(spot, chain, odd)
	chain_build(p, chain, spot, pass);
	group_meet();
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(spot, chain, odd)
	chain_couple(p, chain, spot, odd);
	chain_solve(p, chain);
	for (int odd = 0; odd < 2; ++odd)
	{
		CHAIN_EACH(spot, chain, odd)
		chain_give(p, chain, spot, pass);
		group_meet();
	}
}

INLINE Chain chain_number(const Pools* p, int i)
{
	Chain chain;
	chain.first = p->chain[i].first;
	chain.count = p->chain[i].count;
	chain.stride = p->chain[i].stride;
	chain.lanes = p->chain[i].lanes;
	chain.odds = CHAIN_HALF(chain.count, chain.stride);
	chain.begin = p->counters->layout[CONSTRAINT_JOINT].begin[COLORS];
	return chain;
}

// Item i is a chain, argument the pass.
GROUP_STAGE(chain)
{
	int pass = p->argument;
	Chain chain = chain_number(p, i);
	(void)bench;
	if (pass == PASS_BOUNCE)
		return;
	if (pass == PASS_WARM_START)
		chain_begin(p, &chain);
	for (int odd = 0; odd < 2 && (pass != PASS_RELAX || p->step.drives); ++odd)
	{
		CHAIN_EACH(spot, &chain, odd)
		chain_own(p, &chain, spot, pass);
		group_meet();
	}
	if (pass != PASS_WARM_START)
		chain_locks(p, &chain, pass);
}

// The links get their own inertias back.
GROUP_STAGE(chain_end)
{
	Chain chain = chain_number(p, i);
	for (int k = part_lane(); k < chain.count * chain.lanes; k += part_width())
	{
		int spot = chain_spot_of(&chain, k);
		chain_set_inertias(p, chain.begin + spot, chain_at(p, own_a, spot), chain_at(p, own_b, spot));
	}
	(void)bench;
}

#endif
