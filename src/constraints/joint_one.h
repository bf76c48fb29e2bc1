// SPDX-License-Identifier: MIT
// joint_one.h -- stages of joints that take one joint at a time: limits, springs and motors of the step.
#ifndef JOINT_ONE_H
#define JOINT_ONE_H
#include "constraints/joint_prepare.h"

// The rows of one coordinate. What the user took from it since the last step loses its impulse: whether a pass looks at a
// coordinate without drives depends on the joints beside it.
#define JOINT_DRIVE_SETUP(of, k)                                                                     \
	{                                                                                                \
		JointCoordinate from = p->joint_data[slot].coordinate[k];                                    \
		float rate, soft;                                                                            \
		joint_rare(p, of##_lower, i) = from.lower;                                                   \
		joint_rare(p, of##_upper, i) = from.upper;                                                   \
		joint_softness(p, p->joint_data[slot].hertz, p->joint_data[slot].ratio, 1.0f, &rate, &soft); \
		joint_rare(p, of##_limit_rate, i) = rate;                                                    \
		joint_rare(p, of##_limit_soft, i) = soft;                                                    \
		joint_softness(p, from.spring_hertz, from.spring_ratio, 1.0f, &rate, &soft);                 \
		joint_rare(p, of##_target, i) = from.target;                                                 \
		joint_rare(p, of##_spring_rate, i) = rate;                                                   \
		joint_rare(p, of##_spring_soft, i) = soft;                                                   \
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

// The impulse of a force within a substep.
INLINE float joint_most(const Pools* p, float force)
{
	float impulse = force * p->step.h;
	return impulse <= MOST_IMPULSE ? impulse : MOST_IMPULSE;
}

INLINE void joint_setup_rare(const Pools* p, int i, const Joint* u)
{
	int slot = p->joint_place_slot[i], modes = (int)p->joint_data[slot].modes;
	joint_rare(p, peak_force, i) = 0.0f;
	joint_rare(p, peak_torque, i) = 0.0f;
	if (!p->step.drives)
		return;
	JOINT_DRIVE_SETUP(along, JOINT_ALONG)
	JOINT_DRIVE_SETUP(across, JOINT_ACROSS)
	JOINT_DRIVE_SETUP(angle, JOINT_ANGLE)
	(void)u;
}

INLINE void joint_set_place(const Pools* p, int slot, int i)
{
	(void)p;
	(void)slot;
	(void)i;
}

INLINE int joint_in_use(const Pools* p, int slot) { return (p->joint_flags[slot] & JOINT_THERE) != 0; }

#endif
