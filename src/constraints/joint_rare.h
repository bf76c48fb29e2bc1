// SPDX-License-Identifier: MIT
// joint_rare.h -- computes the rare rows of a joint for the step: limits, springs, motors and soft locks.
#ifndef JOINT_RARE_H
#define JOINT_RARE_H
#include "constraints/coupling.h"
#include "constraints/joint_prepare.h"
#include "constraints/path_constraint.h"

typedef struct // limits, spring and motor of a coordinate, as in JointDriveData
{
	Real lower, upper, spring_hertz, spring_ratio, spring_least, spring_most, speed, motor_most;
} JointDriven;

INLINE JointDriven joint_driven(const Pools* p, Int slot, int k)
{
	Real low[4], high[4];
	joint_quad(p, slot, JOINT_AT_DRIVE(k), low);
	joint_quad(p, slot, JOINT_AT_DRIVE(k) + 1, high);
	JointDriven d = {low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]};
	return d;
}

// N s: Returns the impulse of a force within a substep, at most MOST_IMPULSE.
INLINE Real joint_most(const Pools* p, Real force) { return minimum(splat(MOST_IMPULSE), force * p->step.h); }

// m: Returns the arc length of the foot (JOINT_PATH_ROWS) if k is JOINT_ALONG and the joint is on a path, otherwise 0.
// There, `along` is measured from the foot, because a float is inexact for a long arc.
INLINE Real joint_from_foot(const Pools* p, int i, const Joint* u, int k)
{
	Real zero = splat(0.0f);
	Int railed = joint_has(u, JOINT_RAILED);
	if (k != JOINT_ALONG || !p->step.paths || !lane_bits(railed))
		return zero;
	return only(load(&joint_rare(p, foot_along, i), 0), railed);
}

// Keeps the impulse of a drive, or clears it if the user removed the drive. Passes skip coordinates without drives,
// unless another joint of the same lanes has one: the effect of an impulse left over would depend on other joints.
#define JOINT_DRIVE_KEPT(k, name, mode) \
	store(&joint_drive_row(p, k, name, i), 0, only(load(&joint_drive_row(p, k, name, i), 0), joint_has(u, mode)))

// Writes drive rows of coordinate k; joint_setup_spring writes the others. rate, soft: rate (1/s) and softness of
// limits.
INLINE void joint_setup_drive(const Pools* p, int i, Int slot, int k, const Joint* u, Real rate, Real soft)
{
	JointDriven from = joint_driven(p, slot, k);
	Real lock[4], foot = joint_from_foot(p, i, u, k);
	joint_quad(p, slot, JOINT_AT_LOCK(k), lock);
	store(&joint_drive_row(p, k, lower, i), 0, from.lower - foot);
	store(&joint_drive_row(p, k, upper, i), 0, from.upper - foot);
	store(&joint_drive_row(p, k, target, i), 0, lock[0] - foot);
	store(&joint_drive_row(p, k, limit_rate, i), 0, rate);
	store(&joint_drive_row(p, k, limit_soft, i), 0, soft);
	store(&joint_drive_row(p, k, spring_least, i), 0, -joint_most(p, -from.spring_least));
	store(&joint_drive_row(p, k, spring_most, i), 0, joint_most(p, from.spring_most));
	store(&joint_drive_row(p, k, speed, i), 0, from.speed);
	store(&joint_drive_row(p, k, motor_most, i), 0, joint_most(p, from.motor_most));
	JOINT_DRIVE_KEPT(k, limit_impulse, JOINT_LIMITED(k));
	JOINT_DRIVE_KEPT(k, spring_impulse, JOINT_SPRING(k));
	JOINT_DRIVE_KEPT(k, motor_impulse, JOINT_MOTOR(k));
}

// m: Returns the value of translation k with locks and springs at their targets: 0 for a lock, whose target moves the
// frame; `target` for a spring; otherwise the current value.
INLINE Real joint_aim(const Joint* u, const JointPose* c, int k, Real target)
{
	Real aim = blend(c->value[k], target, joint_has(u, JOINT_SPRING(k)));
	return blend(aim, splat(0.0f), joint_has(u, JOINT_LOCKED(k)));
}

// Returns the factor by which frequency and damping ratio of spring k are multiplied, so that the spring is as stiff as
// if locks and springs were at their targets: the root of (current yield / yield at the targets). 1 for the angle. The
// current arm of body a ends at the anchor of body b, so a longer spring would pull less, and drop its load.
INLINE Real joint_stiffened(const Pools* p, Int slot, const Joint* u, const JointPose* c, int k)
{
	Real one = splat(1.0f), zero = splat(0.0f), lock[4];
	if (k == JOINT_ANGLE)
		return one;
	joint_quad(p, slot, JOINT_AT_LOCK(JOINT_ACROSS - k), lock);
	Real aim = joint_aim(u, c, JOINT_ACROSS - k, lock[0]);
	Real lever = vec_cross(vec(u->arm_a_x, u->arm_a_y), c->axis[k]) + (k == JOINT_ALONG ? -aim : aim);
	Real there = c->mass + c->a.inv_inertia * lever * lever + c->b.inv_inertia * c->lever_b[k] * c->lever_b[k];
	Int yields = there > zero;
	Real ratio = blend(one, quotient(joint_yield(c, k), blend(one, there, yields)), yields);
	Int sound = (ratio < splat(MOST_FLOAT)) & (joint_has(u, JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED) == 0);
	return root(blend(one, ratio, sound));
}

// Writes the rows of the spring or of the soft lock of coordinate k, if a lane has one of the two. The user's frequency
// and damping ratio hold at the target (joint_stiffened). *rate, *hold: correction rate (1/s) and softness of the lock,
// replaced for soft locks. beside, alone: see joint_spring_of.
INLINE void joint_setup_spring(const Pools* p, int i, Int slot, int k, const Joint* u, const JointPose* c, Real beside,
                               Real alone, Real* rate, Real* hold)
{
	Int softens = joint_has(u, JOINT_SOFT(k));
	if (!lane_bits(softens | joint_has(u, JOINT_SPRING(k))))
		return;
	JointDriven from = joint_driven(p, slot, k);
	Real one = splat(1.0f), lock[4], share = joint_share_free(u, c, k), more = joint_stiffened(p, slot, u, c, k);
	joint_quad(p, slot, JOINT_AT_LOCK(k), lock);
	Real hertz = more * blend(from.spring_hertz, lock[1], softens);
	Real ratio = more * blend(from.spring_ratio, lock[2], softens);
	JointSpring s = joint_spring_of(p, hertz, ratio, share, beside, alone);
	Real answer = maximum(one - s.keeps, splat(SPRING_LEAST_ANSWER));
	Real relaxes = minimum(quotient(share * (one - s.relaxes), s.relaxes), splat(JOINT_SOFTEST));
	store(&joint_drive_row(p, k, spring_answer, i), 0, quotient(one - s.keeps, share));
	store(&joint_drive_row(p, k, spring_rate, i), 0, quotient(s.pull * p->step.inv_h, share));
	store(&joint_drive_row(p, k, spring_keeps, i), 0, s.keeps);
	store(&joint_drive_row(p, k, spring_relaxes, i), 0, blend(quotient(s.relaxes, share), relaxes, softens));
	*rate = blend(*rate, quotient(s.pull * p->step.inv_h, answer), softens);
	*hold = blend(*hold, quotient(share * (one - answer), answer), softens);
}

// Returns the largest number of constraints, contacts included, at a movable body of joint i; at least 1.
INLINE Real joint_most_beside(const Pools* p, int i, const JointPose* c)
{
	Real zero = splat(0.0f);
	Real a = real_of(gather_int(p->touching, load_int(&joint_row(p, body_a, i), 0)));
	Real b = real_of(gather_int(p->touching, load_int(&joint_row(p, body_b, i), 0)));
	a = only(a, c->a.inv_mass > zero);
	b = only(b, c->b.inv_mass > zero);
	return maximum(maximum(splat(1.0f), a), b);
}

INLINE Real joint_springs_of(const Joint* u)
{
	Real zero = splat(0.0f), sum = zero;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		sum = sum + only(splat(1.0f), joint_has(u, JOINT_SPRING(k) | JOINT_SOFT(k)));
	return sum;
}

// Computes springs and soft locks from the yields of their coordinates (joint_yield) at the start of the step.
INLINE void joint_setup_springs(const Pools* p, int i, Int slot, Joint* u)
{
	Real zero = splat(0.0f), one = splat(1.0f);
	JointPose c;
	c.a = body_gather(p, load_int(&joint_row(p, body_a, i), 0));
	c.b = body_gather(p, load_int(&joint_row(p, body_b, i), 0));
	c.a.d = c.b.d = vec(zero, zero);
	c.a.da = c.b.da = zero;
	body_turn(&c.a);
	body_turn(&c.b);
	joint_pose(p, i, u, &c);
	coupling_pose(p, i, u, &c);
	path_pose(p, i, u, &c);
	Real most = joint_most_beside(p, i, &c), springs = joint_springs_of(u);
	Real beside = maximum(most * springs, one), alone = blend(one, zero, most > one);
	store(&joint_rare(p, springs_alone, i), 0, only(alone, springs > zero));
	Real rate[3] = {u->rate_along, u->rate_across, u->rate_angle},
	     hold[3] = {u->soft_along, u->soft_across, u->soft_angle};
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		joint_setup_spring(p, i, slot, k, u, &c, beside, alone, rate + k, hold + k);
	u->rate_along = rate[JOINT_ALONG];
	u->rate_across = rate[JOINT_ACROSS];
	u->rate_angle = rate[JOINT_ANGLE];
	u->soft_along = hold[JOINT_ALONG];
	u->soft_across = hold[JOINT_ACROSS];
	u->soft_angle = hold[JOINT_ANGLE];
	store(&joint_row(p, rate_along, i), 0, u->rate_along);
	store(&joint_row(p, rate_across, i), 0, u->rate_across);
	store(&joint_row(p, rate_angle, i), 0, u->rate_angle);
	store(&joint_row(p, soft_along, i), 0, u->soft_along);
	store(&joint_row(p, soft_across, i), 0, u->soft_across);
	store(&joint_row(p, soft_angle, i), 0, u->soft_angle);
}

INLINE void joint_setup_path(const Pools* p, int i, Int slot, const Joint* u)
{
	Real lock[4];
	joint_quad(p, slot, JOINT_AT_LOCK(JOINT_ACROSS), lock);
	store(&joint_rare(p, beside, i), 0, only(lock[0], joint_has(u, JOINT_LOCKED(JOINT_ACROSS))));
}

// Computes all prepared rare rows of joint i, except those that joint_follow wrote.
INLINE void joint_setup_rare(const Pools* p, int i, Joint* u)
{
	Real zero = splat(0.0f), joint[4], rate, soft;
	Int slot = load_int(p->joint_place_slot, i);
	slot = slot & ~(slot >> 31);
	store(&joint_rare(p, springs_alone, i), 0, zero);
	store(&joint_rare(p, peak_force, i), 0, zero);
	store(&joint_rare(p, peak_torque, i), 0, zero);
	if (!p->step.has_drives)
		return;
	joint_quad(p, slot, JOINT_AT_HERTZ, joint);
	joint_softness(p, joint[0], joint[1], splat(1.0f), &rate, &soft);
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		joint_setup_drive(p, i, slot, k, u, rate, soft);
	if (p->step.paths)
		joint_setup_path(p, i, slot, u);
	if (p->step.springs && lane_bits(joint_has(u, JOINT_SPRINGS)))
		joint_setup_springs(p, i, slot, u);
}

#endif
