// SPDX-License-Identifier: MIT
// chain.h -- runs a pass over a chain: the locks of joints in a row are solved together, exactly (chain_solve.h). If
// they were solved one by one, a rope that carries a hundred times a link's mass would need hundreds of passes. The
// host finds such rows of joints (src/world/chain/chains.c); they have no color, and are solved after the colors.
//
// No two joints with even numbers share a body, and no two with odd numbers do. Lanes process joints of one half.
#ifndef CHAIN_H
#define CHAIN_H
#include "stages/solve/chain/chain_stiff.h"

// Applies impulses that do not depend on velocities: the warm start or, in bias, its correction for rotated arms.
INLINE void chain_start(const Pools* p, int place, int pass, ChainLink* link)
{
	if (pass == PASS_WARM_START)
	{
		link->u.carried = load(&joint_row(p, carried, place), 0);
		joint_warm(p, place, &link->u, &link->c);
		store(&joint_row(p, carried, place), 0, link->u.carried);
	}
	if (pass == PASS_BIAS)
		joint_turn(p, place, &link->u, &link->c);
}

// Applies the impulses of a joint that are solved joint by joint: chain_start and, in bias and relax, joint_drive_all.
INLINE void chain_own(const Pools* p, int place, int pass, ChainLink* link)
{
	chain_start(p, place, pass, link);
	if (pass != PASS_WARM_START)
		joint_drive_all(p, place, pass == PASS_BIAS, &link->u, &link->c);
}

// Factor of the diagonal of the linear system. If joints hold a body more than once, as in a welded bridge, the system
// has many solutions; a factor slightly above 1 selects the smallest. It multiplies changes of impulses only, so the
// chain gets no softer.
#define CHAIN_GIVE 1.00001f

// Returns whether the angle of a joint is not locked, but is damped in bias and relax (chain_slack).
INLINE Int chain_damps(const Pools* p, int spot, const Joint* u)
{
	return (CHAIN_AT(p, slack, spot) > splat(0.0f)) & (joint_has(u, JOINT_LOCKED(JOINT_ANGLE)) == 0);
}

INLINE Int chain_damp(const Pools* p, int spot, const ChainLink* link, JointSystem* s)
{
	const JointPose* c = &link->c;
	Real softness = CHAIN_AT(p, slack, spot), ia = c->a.inv_inertia, ib = c->b.inv_inertia;
	Int damps = chain_damps(p, spot, &link->u);
	s->yield[2] = blend(s->yield[2], ia + ib + softness, damps);
	s->soft[2] = blend(s->soft[2], softness, damps);
	Real goal = flush_tiny(joint_speed(c, JOINT_ANGLE) + softness * link->u.impulse_angle);
	s->goal[2] = blend(s->goal[2], -goal, damps);
	s->cross[1] = blend(s->cross[1], joint_yield_turning(c, JOINT_ALONG), damps & s->locked[0]);
	s->cross[2] = blend(s->cross[2], joint_yield_turning(c, JOINT_ACROSS), damps & s->locked[1]);
	s->locked[2] = s->locked[2] | damps;
	return damps;
}

// Computes the equations of a joint: diagonal block, right side, and the data that chain_couple reads.
INLINE void chain_build(const Pools* p, const Chain* chain, int spot, int pass, const ChainLink* link)
{
	chain_keep_pose(p, spot, &link->c);
	float most = p->step.max_speed < JOINT_CORRECTION ? p->step.max_speed : JOINT_CORRECTION;
	JointSystem s = joint_system(p, chain->begin + spot, pass == PASS_BIAS, most, &link->u, &link->c);
	Real locks = splat(0.0f), holds = splat(0.0f);
	Int slack = chain_damp(p, spot, link, &s);
	CHAIN_PUT(p, d[0], spot, CHAIN_GIVE * s.yield[0]);
	CHAIN_PUT(p, d[1], spot, s.cross[0]);
	CHAIN_PUT(p, d[2], spot, s.cross[1]);
	CHAIN_PUT(p, d[3], spot, CHAIN_GIVE * s.yield[1]);
	CHAIN_PUT(p, d[4], spot, s.cross[2]);
	CHAIN_PUT(p, d[5], spot, CHAIN_GIVE * s.yield[2]);
	for (int k = 0; k < 3; ++k)
	{
		CHAIN_PUT(p, r[k], spot, s.goal[k]);
		Int locked = joint_has(&link->u, JOINT_LOCKED(k));
		locks = locks + only(splat((float)(1 << k)), k == JOINT_ANGLE ? locked | slack : locked);
		holds = holds + only(splat((float)(1 << k)), s.locked[k]);
	}
	CHAIN_PUT(p, locks, spot, locks);
	CHAIN_PUT(p, holds, spot, holds);
}

// Computes the off-diagonal block of a joint: the velocities along its coordinates that result from unit impulses of
// the joint before it.
INLINE void chain_couple(const Pools* p, const Chain* chain, ChainPlace place)
{
	int spot = place.spot;
	ChainNear before = chain_neighbor(chain, place.row, place.n, -1);
	Real zero = splat(0.0f), one = splat(1.0f);
	Int right = CHAIN_AT(p, side, spot) > zero, right_there = CHAIN_AT(p, other, spot) > zero;
	Real inverse = CHAIN_AT(p, inv_mass, spot), turning = CHAIN_AT(p, turns, spot);
	Real sign = blend(splat(-1.0f), one, right == right_there), lever[3], across[3];
	Real there[6], locked;
	chain_near(p->chain_joints->pose, 6, before, there);
	chain_near(&p->chain_joints->locks, 1, before, &locked);
	Int holds = whole(CHAIN_AT(p, holds, spot)), locks = whole(locked);
	Vec axis[2], other[2];
	axis[0] = vec(CHAIN_AT(p, pose[0], spot), CHAIN_AT(p, pose[1], spot));
	other[0] = vec(there[0], there[1]);
	axis[1] = vec(-axis[0].y, axis[0].x);
	other[1] = vec(-other[0].y, other[0].x);
	for (int k = 0; k < 2; ++k)
	{
		lever[k] = blend(CHAIN_AT(p, pose[2 + k], spot), CHAIN_AT(p, pose[4 + k], spot), right);
		across[k] = blend(there[2 + k], there[4 + k], right_there);
	}
	lever[JOINT_ANGLE] = across[JOINT_ANGLE] = one;
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j)
		{
			Int wanted = (inverse > zero) & ((holds & (1 << i)) != 0) & ((locks & (1 << j)) != 0);
			Real along = i == JOINT_ANGLE || j == JOINT_ANGLE ? zero : vec_dot(axis[i & 1], other[j & 1]);
			Real value = sign * (inverse * along + turning * lever[i] * across[j]);
			CHAIN_PUT(p, l[3 * i + j], spot, flush_element(only(value, wanted)));
		}
}

// Adds a solution to the impulses of a joint, including the impulse of a damped angle.
INLINE void chain_hold(const Pools* p, int spot, const Real x[3], ChainLink* link)
{
	Int turns = joint_has(&link->u, JOINT_LOCKED(JOINT_ANGLE)) | chain_damps(p, spot, &link->u);
	joint_hold(&p->step, &link->u, &link->c, x, turns);
}

// Applies the impulses of the solution to the bodies of a joint.
INLINE void chain_give(const Pools* p, const Chain* chain, int spot, int pass)
{
	ChainLink link;
	chain_load_kept(p, chain, spot, &link);
	Real x[3] = {CHAIN_AT(p, x[0], spot), CHAIN_AT(p, x[1], spot), CHAIN_AT(p, x[2], spot)};
	chain_hold(p, spot, x, &link);
	if (pass == PASS_RELAX && p->step.has_drives)
		joint_peak(p, chain->begin + spot, &link.u, &link.c);
	chain_store(p, chain, spot, &link);
}

// Processes the even or odd joints of a chain: runs chain_own if `owns` is 1, then chain_build if `builds` is 1.
INLINE void chain_half(const Pools* p, const Chain* chain, int odd, int pass, int owns, int builds)
{
	if (!owns && !builds)
		return;
	CHAIN_EACH(at, chain, odd)
	{
		ChainLink link;
		chain_load_posed(p, chain->begin + at.spot, &link);
		if (owns)
		{
			chain_own(p, chain->begin + at.spot, pass, &link);
			chain_store(p, chain, at.spot, &link);
		}
		if (builds)
			chain_build(p, chain, at.spot, pass, &link);
	}
}

INLINE_MEET void chain_locks(const Pools* p, const Chain* chain, int pass)
{
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(at, chain, odd)
	chain_couple(p, chain, at);
	chain_solve(p, chain);
	for (int odd = 0; odd < 2; ++odd)
	{
		CHAIN_EACH(at, chain, odd)
		chain_give(p, chain, at.spot, pass);
		group_meet();
	}
}

INLINE Chain chain_number(const Pools* p, int i)
{
	Chain chain;
	chain.at = p->chain[i];
	chain.begin = p->counters->layout[CONSTRAINT_JOINT].begin[COLORS];
	return chain;
}

INLINE_MEET void chain_pass(const Pools* p, Chain chain, int pass)
{
	// three turns: even joints, odd joints, even joints. The equations of a joint need its neighbors' velocities after
	// chain_own, so the equations of odd joints are computed in the second turn, those of even joints in the third.
	// Without chain_own, two turns are enough
	int owns = pass != PASS_RELAX || p->step.has_drives, solves = pass != PASS_WARM_START;
	for (int turn = 0; turn < 3; ++turn)
	{
		chain_half(p, &chain, turn & 1, pass, owns && turn < 2, solves && (owns ? turn > 0 : turn < 2));
		group_meet();
	}
	if (solves)
		chain_locks(p, &chain, pass);
}

// Sets chain_live of item i if some joint of it acts, in a world that sleeps. first, spots: range of spots of joints.
// Spots of interleaved chains may lie between; if only joints of these act, the item is solved, and nothing changes.
// Called by a whole group, after chain_live was cleared.
INLINE void chain_look(const Pools* p, int i, int first, int spots)
{
	int begin = p->counters->layout[CONSTRAINT_JOINT].begin[COLORS];
	int most = p->counters->layout[CONSTRAINT_JOINT].begin[COLORS + 1];
	for (int k = begin + first + part_lane(); k < begin + first + spots && k < most; k += part_width())
		if (p->joint_place_slot[k] >= 0)
			write_shared_word((GLOBAL Word*)p->chain_live + i, 1u);
}

// Returns whether item i of a pass has nothing to solve, because the bodies of all its joints sleep.
INLINE int chain_sleeps(const Pools* p, int i) { return p->step.sleep && read_shared(p->chain_live + i) == 0; }

// Item: one range of chains, or several ranges in the same blocks of the pool chain_joints. argument: the pass.
GROUP_KERNEL(chain)
{
	int first = p->chain[i].item;
	(void)bench;
	if (p->argument == PASS_BOUNCE || chain_sleeps(p, i))
		return;
	for (int k = 0; k < p->chain[first].parts; ++k)
	{
		Chain chain = chain_number(p, first + k);
		if (LANES > 1 && chain_side(&chain))
		{
			// separate call with constant stride and bits; otherwise a tenth of the instructions would compute spots
			chain.at.stride = MAX_LANES;
			chain.at.bits = 1;
			chain_pass(p, chain, p->argument);
		}
		else
		{
			chain.at.stride = 1;
			chain_pass(p, chain, p->argument);
		}
	}
}

// Sets the inertias of the links for the step before any constraint acts. Otherwise other constraints would rotate a
// link with its original inertia, and the chain would rotate it back by another angle with the raised one: this kick
// tore ropes.
GROUP_KERNEL(chain_begin)
{
	(void)bench;
	int first = p->chain[i].item;
	if (p->step.sleep)
	{
		if (part_lane() == 0)
			p->chain_live[i] = 0;
		group_meet();
		for (int k = 0; k < p->chain[first].parts; ++k)
		{
			ChainRange range = p->chain[first + k];
			int last = CHAIN_SPOT(&range, (range.length << range.bits) - 1);
			chain_look(p, i, range.first, last + range.stride - range.first);
		}
		group_meet();
		if (chain_sleeps(p, i))
			return;
	}
	for (int k = 0; k < p->chain[first].parts; ++k)
	{
		Chain chain = chain_number(p, first + k);
		chain_stretch(p, &chain);
	}
}

// Restores the inertias of the links after the step.
INLINE void chain_restore(const Pools* p, Chain chain)
{
	for (int odd = 0; odd < 2; ++odd)
		CHAIN_EACH(at, &chain, odd)
	for (int k = at.spot; k < at.spot + LANES; ++k)
		chain_set_inertias(p, chain.begin + k, chain_at(p, own_a, k), chain_at(p, own_b, k));
}

GROUP_KERNEL(chain_end)
{
	(void)bench;
	int first = p->chain[i].item;
	if (chain_sleeps(p, i))
		return;
	for (int k = 0; k < p->chain[first].parts; ++k)
		chain_restore(p, chain_number(p, first + k));
}

#endif
