// SPDX-License-Identifier: MIT
// branch_drive.h -- adds motors and limits to the equations of a branch, except those whose impulse is at its bound.
//
// First, each drive (motor or limit) is solved separately, as in joints outside branches. A motor below its maximum,
// and a limit with an impulse, then hold their coordinates like locks: friction in the hinges of a light body couples
// its ends as much as the hinges do. If an impulse reaches its bound in the solution, it stays there, and the rest is
// solved again.
#ifndef BRANCH_DRIVE_H
#define BRANCH_DRIVE_H
#include "stages/solve/chain/chain.h"

#define HELD_BY_NONE  0
#define HELD_BY_MOTOR 1
#define HELD_BY_LIMIT 2

// Returns HELD_BY_* of the drive that holds coordinate k: HELD_BY_NONE if no drive does, or if k is locked, or is along
// or across with JOINT_ELLIPTIC.
INLINE int branch_holder(const JointDrive* d, int modes, int k)
{
	if (modes & (k == JOINT_ANGLE ? JOINT_LOCKED(k) : JOINT_LOCKED(k) | JOINT_ELLIPTIC))
		return HELD_BY_NONE;
	if (modes & JOINT_LIMITED(k) && d->limit_impulse != 0.0f)
		return HELD_BY_LIMIT;
	return modes & JOINT_MOTOR(k) && absolute(d->motor_impulse) < d->motor_most ? HELD_BY_MOTOR : HELD_BY_NONE;
}

// Adds the equations of drives that hold coordinates to `s`. Returns HELD_BY_* of each coordinate, in 2 bits each.
INLINE int branch_drives(const Pools* p, int place, int soft, const ChainLink* link, JointSystem* s)
{
	int modes = (int)link->u.modes, held = 0;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		float yield = joint_yield(&link->c, k);
		if (!(modes & JOINT_HAS_DRIVES(k)) || !(yield > 0.0f))
			continue;
		JointDrive d = joint_drive_load(p, place, k);
		int holder = branch_holder(&d, modes, k);
		if (holder == HELD_BY_NONE)
			continue;
		float speed = joint_speed(&link->c, k), value = link->c.value[k];
		held |= holder << 2 * k;
		s->locked[k] = 1;
		s->soft[k] = 0.0f;
		s->goal[k] = joint_motor_speed(p, &d, k, value, (modes & JOINT_LIMITED(k)) != 0, soft) - speed;
		if (holder == HELD_BY_MOTOR)
			continue;
		int low = value - d.lower < d.upper - value;
		float gap = low ? value - d.lower : d.upper - value, sign = low ? 1.0f : -1.0f;
		float bias = joint_limit_speed(p, &d, k, gap, soft);
		s->soft[k] = gap > 0.0f || !soft ? 0.0f : d.limit_soft * yield;
		s->goal[k] = -(speed + sign * (bias + s->soft[k] * joint_limit_load(&d, sign, sign * d.limit_impulse)));
	}
	return held;
}

// Returns the impulse of a drive after it has changed by x, limited to the bounds of the drive.
INLINE float branch_bounded(const Step* step, const JointDrive* d, int holder, float x, float yield)
{
	if (holder == HELD_BY_MOTOR)
		return grip_of(joint_bounded(step, d->motor_impulse + x, yield), d->motor_most);
	float now = joint_bounded(step, d->limit_impulse + x, yield);
	return d->limit_impulse > 0.0f ? push_of(now) : -push_of(-now);
}

// Sets the impulse of the drive that holds coordinate k to `now`, and applies the change to the bodies.
INLINE void branch_set(const Pools* p, int place, int holder, int k, float now, JointDrive* d, ChainLink* link)
{
	float change = now - (holder == HELD_BY_MOTOR ? d->motor_impulse : d->limit_impulse);
	if (holder == HELD_BY_MOTOR)
		d->motor_impulse = now;
	else
		d->limit_impulse = now;
	joint_drive_store(p, place, k, d);
	joint_give(&link->u, &link->c,
	           joint_impulse(&link->c, k == JOINT_ALONG ? change : 0.0f, k == JOINT_ACROSS ? change : 0.0f,
	                         k == JOINT_ANGLE ? change : 0.0f));
}

// Finds the drives of a joint whose impulses would exceed their bounds with the solution x, and sets these impulses to
// the bounds. Returns whether there is such a drive.
INLINE int branch_beyond(const Pools* p, int place, int held, const float x[3], ChainLink* link)
{
	int found = 0;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		int holder = held >> 2 * k & 3;
		if (holder == HELD_BY_NONE)
			continue;
		JointDrive d = joint_drive_load(p, place, k);
		float now = branch_bounded(&p->step, &d, holder, x[k], joint_yield(&link->c, k));
		int beyond = holder == HELD_BY_MOTOR ? absolute(now) >= d.motor_most : now == 0.0f;
		found |= beyond;
		if (beyond)
			branch_set(p, place, holder, k, now, &d, link);
	}
	return found;
}

// Adds the solution x to the impulses of drives that hold coordinates, and clears x there; the rest is for the locks.
INLINE void branch_drive(const Pools* p, int place, int held, float x[3], ChainLink* link)
{
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		int holder = held >> 2 * k & 3;
		if (holder == HELD_BY_NONE)
			continue;
		JointDrive d = joint_drive_load(p, place, k);
		branch_set(p, place, holder, k, branch_bounded(&p->step, &d, holder, x[k], joint_yield(&link->c, k)), &d, link);
		x[k] = 0.0f;
	}
}

#endif
