// SPDX-License-Identifier: MIT
// contact_approval.h -- lists contacts that the user must approve, and stops their bodies where they meet.
//
// A pending contact has points but no impulses. Its bodies move only until they meet, so that they do not pass through
// each other before the user has decided. The bodies keep their velocities (docs/manual/rules.md, Contact approval).
#ifndef CONTACT_APPROVAL_H
#define CONTACT_APPROVAL_H
#include "constraints/angle.h"
#include "stages/finalize/continuous.h"
#include "stages/finalize/finalize.h"

// Item: a contact, after the narrow phase. Lists a pending contact that has points, unless it was refused. Writes the
// keys of refused contacts, and of contacts that a one-way platform lets through, for continuous collision. argument: 1
// if there are one-way platforms; in this case also raises the depths of their visitors (sunk_find).
KERNEL(approval_request)
{
	Word flags = p->contact_flags[i];
	if (i >= p->counters->live)
		return;
	if (p->argument)
	{
		int found = (flags & CONTACT_SUNK) != 0;
		flags &= ~CONTACT_SUNK;
		sunk_find(p, i, flags, found);
		p->contact_flags[i] = flags;
	}
	if (flags & CONTACT_PASSES)
		p->key[atomic_add_int(&p->counters->refused, 1)] = apart_passes_key(p, p->pair[i]);
	if (!(flags & CONTACT_PENDING) || flags & CONTACT_APART || !(flags & CONTACT_COUNT))
		return;
	if (flags & CONTACT_REFUSED)
	{
		p->key[atomic_add_int(&p->counters->refused, 1)] = apart_key(p, p->pair[i]);
		return;
	}
	p->contact_flags[i] = flags | CONTACT_WAITED;
	p->waiting[atomic_add_int(&p->counters->waiting, 1)] = i;
	raise_int(&p->counters->holds, 0x7fffffff);
}

KERNEL(refused_pair) { p->refused[i] = p->key[i]; }

// Lists contact i at the end of the step if approval_request listed it. It keeps this slot until the next step.
KERNEL(approval_list)
{
	if (p->contact_flags[i] & CONTACT_WAITED)
		p->asked[atomic_add_int(&p->counters->asked, 1)] = i;
}

// Stores the pose of body i before the solve.
KERNEL(approval_begin)
{
	p->approval_pose[i] = p->pose[i];
	p->approval_low[i] = p->pose_low[i];
	p->approval_fraction[i] = float_bits(1.0f);
}

// Returns the motion of body i in the step, computed from its poses before and after the solve.
INLINE Advance approval_advance(const Pools* p, int i)
{
	Float4 then = p->approval_pose[i], now = p->pose[i];
	Float2 low = p->approval_low[i], end = p->pose_low[i];
	Advance advance;
	advance.path = vec((now.x - then.x) + (end.x - low.x), (now.y - then.y) + (end.y - low.y));
	advance.turn = vec_angle(vec_turn_back(vec(then.z, then.w), vec(now.z, now.w)));
	return advance;
}

INLINE Sweep approval_sweep(const Pools* p, WorldShape s)
{
	const GLOBAL Attribute* attribute = p->attribute + s.attribute;
	return sweep_with(approval_advance(p, s.body), vec(s.center_x, s.center_y), attribute->reach - attribute->radius);
}

// Item: a pending contact. Limits the motion of its two bodies to the fraction of the step after which they meet.
KERNEL(approval_find)
{
	int slot = p->waiting[i];
	Int2 pair = p->pair[slot], bodies = p->contact_bodies[slot];
	WorldShape a = p->world_shape[pair.x], b = p->world_shape[pair.y];
	ContinuousDepth meets = {SWEEP_DEPTH, SWEEP_DEPTH, CONTINUOUS_TOLERANCE, 0.0f};
	float share = continuous_time(p, a, approval_sweep(p, a), b, approval_sweep(p, b), meets).time;
	if (!(share < 1.0f))
		return;
	// bits of non-negative floats, as integers, have the same order as the floats
	atomic_min_int(&p->approval_fraction[bodies.x], float_bits(share));
	atomic_min_int(&p->approval_fraction[bodies.y], float_bits(share));
}

// Moves body i, after the solve, back to the pose at which it first met the other body of a pending contact.
KERNEL(approval_stop)
{
	float share = bits_float(p->approval_fraction[i]);
	if (!(share < 1.0f) || !(p->body[i].inv_mass > 0.0f))
		return;
	Advance advance = approval_advance(p, i);
	p->pose[i] = p->approval_pose[i];
	p->pose_low[i] = p->approval_low[i];
	finalize_pose(p, i, vec_scale(share, advance.path), share * advance.turn);
}

#endif
