// SPDX-License-Identifier: MIT
// joint_one.h -- stages of joints that take one joint at a time: limits, springs and motors of the step.
#ifndef JOINT_ONE_H
#define JOINT_ONE_H
#include "constraints/coupling.h"
#include "constraints/coupling_one.h"
#include "constraints/path.h"
#include "constraints/path_one.h"

// The rows of one coordinate. What the user took from it since the last step loses its impulse: whether a pass looks at a
// coordinate without drives depends on the joints beside it.
#define JOINT_DRIVE_SETUP(of, k)                                                                     \
	{                                                                                                \
		JointDriveData from = p->joint_data[slot].drive[k];                                          \
		float rate, soft;                                                                            \
		joint_rare(p, of##_lower, i) = from.lower;                                                   \
		joint_rare(p, of##_upper, i) = from.upper;                                                   \
		joint_softness(p, p->joint_data[slot].hertz, p->joint_data[slot].ratio, 1.0f, &rate, &soft); \
		joint_rare(p, of##_limit_rate, i) = rate;                                                    \
		joint_rare(p, of##_limit_soft, i) = soft;                                                    \
		joint_rare(p, of##_target, i) = p->joint_data[slot].lock[k].target;                          \
		joint_rare(p, of##_spring_least, i) = -joint_most(p, -from.spring_least);                    \
		joint_rare(p, of##_spring_most, i) = joint_most(p, from.spring_most);                        \
		joint_rare(p, of##_speed, i) = from.speed;                                                   \
		joint_rare(p, of##_motor_most, i) = joint_most(p, from.motor_most);                          \
		if (!(modes & JOINT_LIMITED(k)))                                                             \
			joint_rare(p, of##_limit_impulse, i) = 0.0f;                                             \
		if (!(modes & JOINT_SPRING(k)))                                                              \
			joint_rare(p, of##_spring_impulse, i) = 0.0f;                                            \
		if (!(modes & JOINT_MOTOR(k)))                                                               \
			joint_rare(p, of##_motor_impulse, i) = 0.0f;                                             \
	}

// The place of coordinate k, a translation, with locks and springs at their targets, m. A lock moves the frame to its target.
INLINE float joint_aim(const Pools* p, int slot, int modes, const JointPose* c, int k)
{
	if (modes & JOINT_LOCKED(k))
		return 0.0f;
	return modes & JOINT_SPRING(k) ? p->joint_data[slot].lock[k].target : c->value[k];
}

// How much stiffer a spring of coordinate k is than one of the same frequency with arms as they are now: the root of a ratio of
// yields. The stiffness is that of arms where locks and springs are at their targets. The arm of body a ends at the anchor of b:
// a spring whose stiffness followed its length would pull the less the longer it is, and lose its load.
INLINE float joint_stiffened(const Pools* p, int slot, int modes, const Joint* u, const JointPose* c, int k)
{
	if (k == JOINT_ANGLE || modes & (JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED))
		return 1.0f;
	float aim = joint_aim(p, slot, modes, c, JOINT_ACROSS - k);
	float lever = vec_cross(vec(u->arm_a_x, u->arm_a_y), c->axis[k]) + (k == JOINT_ALONG ? -aim : aim);
	float own = joint_yield(c, k);
	float there = c->mass + c->a.inv_inertia * lever * lever + c->b.inv_inertia * c->lever_b[k] * c->lever_b[k];
	float ratio = there > 0.0f ? own / there : 1.0f;
	return ratio < MOST_FLOAT ? root(ratio) : 1.0f;
}

// The spring of coordinate k with a frequency and a damping ratio, and the stiffness that it has at its target (joint_spring_of has the rest).
INLINE JointSpring joint_spring_at(const Pools* p, int slot, int k, const Joint* u, const JointPose* c, float hertz,
                                   float ratio, float share, float beside, float alone)
{
	float more = joint_stiffened(p, slot, (int)p->joint_data[slot].modes, u, c, k);
	return joint_spring_of(p, more * hertz, more * ratio, share, beside, alone);
}

// The spring of one coordinate, or its soft lock.
#define JOINT_SPRING_SETUP(of, k)                                                                               \
	if (modes & JOINT_SPRING(k))                                                                                \
	{                                                                                                           \
		JointDriveData from = p->joint_data[slot].drive[k];                                                     \
		float share = joint_share_free(u, &c, k);                                                               \
		JointSpring s =                                                                                         \
		    joint_spring_at(p, slot, k, u, &c, from.spring_hertz, from.spring_ratio, share, beside, alone);     \
		joint_rare(p, of##_spring_answer, i) = (1.0f - s.keeps) / share;                                        \
		joint_rare(p, of##_spring_rate, i) = s.pull * p->step.inv_h / share;                                    \
		joint_rare(p, of##_spring_keeps, i) = s.keeps;                                                          \
		joint_rare(p, of##_spring_relaxes, i) = s.relaxes / share;                                              \
	}                                                                                                           \
	if (modes & JOINT_SOFT(k))                                                                                  \
	{                                                                                                           \
		JointLock from = p->joint_data[slot].lock[k];                                                           \
		float share = joint_share_free(u, &c, k);                                                               \
		JointSpring s = joint_spring_at(p, slot, k, u, &c, from.hertz, from.ratio, share, beside, alone);       \
		float answer = maximum(1.0f - s.keeps, SPRING_LEAST_ANSWER);                                            \
		u->rate_##of = s.pull * p->step.inv_h / answer;                                                         \
		u->soft_##of = share * (1.0f - answer) / answer;                                                        \
		joint_row(p, rate_##of, i) = u->rate_##of;                                                              \
		joint_row(p, soft_##of, i) = u->soft_##of;                                                              \
		joint_rare(p, of##_spring_relaxes, i) = minimum(share * (1.0f - s.relaxes) / s.relaxes, JOINT_SOFTEST); \
	}

// The impulse of a force within a substep.
INLINE float joint_most(const Pools* p, float force)
{
	float impulse = force * p->step.h;
	return impulse <= MOST_IMPULSE ? impulse : MOST_IMPULSE;
}

// Constraints of a body, contacts too; 0 of what cannot move.
INLINE int joint_beside(const Pools* p, int body, float inv_mass) { return inv_mass > 0.0f ? p->touching[body] : 0; }

// Constraints of the body of joint i that has the most; at least 1.
INLINE int joint_most_beside(const Pools* p, int i, const JointPose* c)
{
	int a = joint_beside(p, joint_row(p, body_a, i), c->a.inv_mass);
	int b = joint_beside(p, joint_row(p, body_b, i), c->b.inv_mass), most = a > b ? a : b;
	return most > 1 ? most : 1;
}

INLINE int joint_springs_of(int modes)
{
	int springs = 0;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		springs += (modes & (JOINT_SPRING(k) | JOINT_SOFT(k))) != 0;
	return springs;
}

// Springs and soft locks: their coefficients follow from how much the coordinate yields at the poses of the step's start.
INLINE void joint_setup_springs(const Pools* p, int i, Joint* u)
{
	int slot = p->joint_place_slot[i], modes = (int)p->joint_data[slot].modes;
	JointPose c;
	c.a = body_gather(p, joint_row(p, body_a, i));
	c.b = body_gather(p, joint_row(p, body_b, i));
	c.a.d = c.b.d = vec(0.0f, 0.0f);
	c.a.da = c.b.da = 0.0f;
	body_turn(&c.a);
	body_turn(&c.b);
	joint_pose(p, i, u, &c);
	coupling_pose(p, i, u, &c);
	path_pose(p, i, u, &c);
	int most = joint_most_beside(p, i, &c);
	float beside = (float)most * (float)joint_springs_of(modes), alone = most > 1 ? 0.0f : 1.0f;
	joint_rare(p, springs_alone, i) = alone;
	JOINT_SPRING_SETUP(along, JOINT_ALONG)
	JOINT_SPRING_SETUP(across, JOINT_ACROSS)
	JOINT_SPRING_SETUP(angle, JOINT_ANGLE)
}

INLINE void joint_setup_rare(const Pools* p, int i, Joint* u)
{
	int slot = p->joint_place_slot[i], modes = (int)p->joint_data[slot].modes;
	joint_rare(p, springs_alone, i) = 0.0f;
	joint_rare(p, peak_force, i) = 0.0f;
	joint_rare(p, peak_torque, i) = 0.0f;
	if (!p->step.drives)
		return;
	JOINT_DRIVE_SETUP(along, JOINT_ALONG)
	JOINT_DRIVE_SETUP(across, JOINT_ACROSS)
	JOINT_DRIVE_SETUP(angle, JOINT_ANGLE)
	if (modes & JOINT_COUPLED)
		coupling_setup(p, i);
	if (modes & JOINT_RAILED)
		path_setup(p, i);
	if (modes & JOINT_SPRINGS)
		joint_setup_springs(p, i, u);
}

// What is counted of turns: of a joint that is at no place, because it rests, at its slot.
INLINE float joint_turned_last(const Pools* p, int slot)
{
	int place = p->joint_place[slot];
	if (p->joint_flags[slot] & JOINT_NEW)
		return 0.0f;
	return place < 0 ? p->joint_kept[slot].turned : joint_row(p, turned, place);
}

INLINE CouplingCount coupling_count_last(const Pools* p, int slot)
{
	int place = p->joint_place[slot];
	if (p->joint_flags[slot] & JOINT_NEW)
		return coupling_count_new(p, slot);
	if (place >= 0)
		return coupling_count_at(p, place);
	const GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	CouplingCount count = {{kept->angle_a, kept->angle_b}, {kept->turns_a, kept->turns_b}, kept->geared};
	return count;
}

// Stores what was counted, at a place, or at the slot of a joint that is at none.
INLINE void coupling_count_store(const Pools* p, int slot, int place, const CouplingCount* count)
{
	GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	if (place >= 0)
	{
		coupling_count_put(p, place, count);
		return;
	}
	kept->angle_a = count->angle[0];
	kept->angle_b = count->angle[1];
	kept->turns_a = count->turns[0];
	kept->turns_b = count->turns[1];
	kept->geared = count->geared;
}

INLINE PathCount path_count_last(const Pools* p, int slot)
{
	int place = p->joint_place[slot];
	if (p->joint_flags[slot] & JOINT_NEW)
		return path_count_new();
	if (place >= 0)
		return path_count_at(p, place);
	const GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	PathCount count = {kept->path_segment, kept->path_laps, kept->path_seeks};
	return count;
}

INLINE void path_count_store(const Pools* p, int slot, int place, const PathCount* count)
{
	GLOBAL JointRareKept* kept = p->joint_rare_kept + slot;
	if (place >= 0)
	{
		path_count_put(p, place, count);
		return;
	}
	kept->path_segment = count->segment;
	kept->path_laps = count->laps;
	kept->path_seeks = count->seeks;
}

INLINE void joint_set_place(const Pools* p, int slot, int i)
{
	(void)p;
	(void)slot;
	(void)i;
}

INLINE int joint_in_use(const Pools* p, int slot) { return (p->joint_flags[slot] & JOINT_THERE) != 0; }

#endif
