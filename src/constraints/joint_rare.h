// SPDX-License-Identifier: MIT
// joint_rare.h -- the rare rows of a joint for the step: its limits, springs and motors, and soft locks.
#ifndef JOINT_RARE_H
#define JOINT_RARE_H
#include "constraints/coupling.h"
#include "constraints/joint_prepare.h"
#include "constraints/path.h"

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

// The impulse of a force within a substep.
INLINE Real joint_most(const Pools* p, Real force) { return minimum(splat(MOST_IMPULSE), force * p->step.h); }

// m: along a path counts from the foot within a step: far along it a float has few digits left for what a substep moves
INLINE Real joint_from_foot(const Pools* p, int i, const Joint* u, int k)
{
	Real zero = splat(0.0f);
	Int railed = joint_has(u, JOINT_RAILED);
	if (k != JOINT_ALONG || !p->step.paths || !lane_bits(railed))
		return zero;
	return choose(zero, load(&joint_rare(p, foot_along, i), 0), railed);
}

// The impulse of a drive of the last step. What the user took from the coordinate since then loses it: whether a pass looks at a coordinate
// without drives depends on the joints beside it.
#define JOINT_DRIVE_KEPT(name, mode) \
	store(&joint_rare(p, name, i), 0, choose(splat(0.0f), load(&joint_rare(p, name, i), 0), joint_has(u, mode)))

// The rows of one coordinate but for its spring.
#define JOINT_DRIVE_SETUP(of, k)                                                            \
	{                                                                                       \
		JointDriven from = joint_driven(p, slot, k);                                        \
		Real lock[4], foot = joint_from_foot(p, i, u, k);                                   \
		joint_quad(p, slot, JOINT_AT_LOCK(k), lock);                                        \
		store(&joint_rare(p, of##_lower, i), 0, from.lower - foot);                         \
		store(&joint_rare(p, of##_upper, i), 0, from.upper - foot);                         \
		store(&joint_rare(p, of##_target, i), 0, lock[0] - foot);                           \
		store(&joint_rare(p, of##_limit_rate, i), 0, rate);                                 \
		store(&joint_rare(p, of##_limit_soft, i), 0, soft);                                 \
		store(&joint_rare(p, of##_spring_least, i), 0, -joint_most(p, -from.spring_least)); \
		store(&joint_rare(p, of##_spring_most, i), 0, joint_most(p, from.spring_most));     \
		store(&joint_rare(p, of##_speed, i), 0, from.speed);                                \
		store(&joint_rare(p, of##_motor_most, i), 0, joint_most(p, from.motor_most));       \
		JOINT_DRIVE_KEPT(of##_limit_impulse, JOINT_LIMITED(k));                             \
		JOINT_DRIVE_KEPT(of##_spring_impulse, JOINT_SPRING(k));                             \
		JOINT_DRIVE_KEPT(of##_motor_impulse, JOINT_MOTOR(k));                               \
	}

// The place of coordinate k, a translation, with locks and springs at their targets, m. A lock moves the frame to its target.
INLINE Real joint_aim(const Joint* u, const JointPose* c, int k, Real target)
{
	Real aim = choose(c->value[k], target, joint_has(u, JOINT_SPRING(k)));
	return choose(aim, splat(0.0f), joint_has(u, JOINT_LOCKED(k)));
}

// How much stiffer a spring of coordinate k is than one of the same frequency with arms as they are now: the root of a ratio of
// yields. The stiffness is that of arms where locks and springs are at their targets. The arm of body a ends at the anchor of b:
// a spring whose stiffness followed its length would pull the less the longer it is, and lose its load.
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
	Real ratio = choose(one, joint_yield(c, k) / choose(one, there, yields), yields);
	Int sound = (ratio < splat(MOST_FLOAT)) & (joint_has(u, JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED) == 0);
	return root(choose(one, ratio, sound));
}

typedef struct // the rows of a spring, and of a soft lock
{
	Real answer, rate, keeps, relaxes, lock_rate, lock_soft;
} JointSpringRows;

// Those of coordinate k: a coordinate has a spring or a soft lock at most. Frequency and ratio are meant for the stiffness that it has at its
// target.
RARE JointSpringRows joint_spring_rows(const Pools* p, Int slot, int k, const Joint* u, const JointPose* c, Real beside,
                                       Real alone)
{
	Int softens = joint_has(u, JOINT_SOFT(k));
	JointDriven from = joint_driven(p, slot, k);
	Real one = splat(1.0f), lock[4], share = joint_share_free(u, c, k), more = joint_stiffened(p, slot, u, c, k);
	joint_quad(p, slot, JOINT_AT_LOCK(k), lock);
	Real hertz = more * choose(from.spring_hertz, lock[1], softens);
	Real ratio = more * choose(from.spring_ratio, lock[2], softens);
	JointSpring s = joint_spring_of(p, hertz, ratio, share, beside, alone);
	Real answer = maximum(one - s.keeps, splat(SPRING_LEAST_ANSWER));
	Real relaxes = minimum(share * (one - s.relaxes) / s.relaxes, splat(JOINT_SOFTEST));
	JointSpringRows rows;
	rows.answer = (one - s.keeps) / share;
	rows.rate = s.pull * p->step.inv_h / share;
	rows.keeps = s.keeps;
	rows.relaxes = choose(s.relaxes / share, relaxes, softens);
	rows.lock_rate = s.pull * p->step.inv_h / answer;
	rows.lock_soft = share * (one - answer) / answer;
	return rows;
}

#define JOINT_SPRING_SETUP(of, k)                                                         \
	if (lane_bits(joint_has(u, JOINT_SOFT(k) | JOINT_SPRING(k))))                         \
	{                                                                                     \
		JointSpringRows rows = joint_spring_rows(p, slot, k, u, &c, beside, alone);       \
		store(&joint_rare(p, of##_spring_answer, i), 0, rows.answer);                     \
		store(&joint_rare(p, of##_spring_rate, i), 0, rows.rate);                         \
		store(&joint_rare(p, of##_spring_keeps, i), 0, rows.keeps);                       \
		store(&joint_rare(p, of##_spring_relaxes, i), 0, rows.relaxes);                   \
		u->rate_##of = choose(u->rate_##of, rows.lock_rate, joint_has(u, JOINT_SOFT(k))); \
		u->soft_##of = choose(u->soft_##of, rows.lock_soft, joint_has(u, JOINT_SOFT(k))); \
	}

// Constraints of the body of joint i that has the most, contacts too, without those of what cannot move; at least 1.
INLINE Real joint_most_beside(const Pools* p, int i, const JointPose* c)
{
	Real zero = splat(0.0f);
	Real a = real_of(gather_int(p->touching, load_int(&joint_row(p, body_a, i), 0)));
	Real b = real_of(gather_int(p->touching, load_int(&joint_row(p, body_b, i), 0)));
	a = choose(zero, a, c->a.inv_mass > zero);
	b = choose(zero, b, c->b.inv_mass > zero);
	return maximum(maximum(splat(1.0f), a), b);
}

INLINE Real joint_springs_of(const Joint* u)
{
	Real zero = splat(0.0f), sum = zero;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		sum = sum + choose(zero, splat(1.0f), joint_has(u, JOINT_SPRING(k) | JOINT_SOFT(k)));
	return sum;
}

// Springs and soft locks: their coefficients follow from how much the coordinate yields at the poses of the step's start.
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
	Real beside = maximum(most * springs, one), alone = choose(one, zero, most > one);
	store(&joint_rare(p, springs_alone, i), 0, choose(zero, alone, springs > zero));
	JOINT_SPRING_SETUP(along, JOINT_ALONG)
	JOINT_SPRING_SETUP(across, JOINT_ACROSS)
	JOINT_SPRING_SETUP(angle, JOINT_ANGLE)
	store(&joint_row(p, rate_along, i), 0, u->rate_along);
	store(&joint_row(p, rate_across, i), 0, u->rate_across);
	store(&joint_row(p, rate_angle, i), 0, u->rate_angle);
	store(&joint_row(p, soft_along, i), 0, u->soft_along);
	store(&joint_row(p, soft_across, i), 0, u->soft_across);
	store(&joint_row(p, soft_angle, i), 0, u->soft_angle);
}

// m: where the lock across a path holds
INLINE void joint_setup_path(const Pools* p, int i, Int slot, const Joint* u)
{
	Real lock[4];
	joint_quad(p, slot, JOINT_AT_LOCK(JOINT_ACROSS), lock);
	store(&joint_rare(p, beside, i), 0, choose(splat(0.0f), lock[0], joint_has(u, JOINT_LOCKED(JOINT_ACROSS))));
}

// All rare rows of joint i that are prepared, but for those that joint_follow wrote.
INLINE void joint_setup_rare(const Pools* p, int i, Joint* u)
{
	Real zero = splat(0.0f), joint[4], rate, soft;
	Int slot = load_int(p->joint_place_slot, i);
	slot = slot & ~(slot >> 31);
	store(&joint_rare(p, springs_alone, i), 0, zero);
	store(&joint_rare(p, peak_force, i), 0, zero);
	store(&joint_rare(p, peak_torque, i), 0, zero);
	if (!p->step.drives)
		return;
	joint_quad(p, slot, JOINT_AT_HERTZ, joint);
	joint_softness(p, joint[0], joint[1], splat(1.0f), &rate, &soft);
	JOINT_DRIVE_SETUP(along, JOINT_ALONG)
	JOINT_DRIVE_SETUP(across, JOINT_ACROSS)
	JOINT_DRIVE_SETUP(angle, JOINT_ANGLE)
	if (p->step.paths)
		joint_setup_path(p, i, slot, u);
	if (p->step.springs && lane_bits(joint_has(u, JOINT_SPRINGS)))
		joint_setup_springs(p, i, slot, u);
}

#endif
