// SPDX-License-Identifier: MIT
// joint_asleep.h -- reads and scales the impulses of a joint whose bodies sleep. They are kept at the joint's slot.
#ifndef JOINT_ASLEEP_H
#define JOINT_ASLEEP_H
#include "constraints/constraint_kinds.h"

// Processes the impulses of one coordinate: X(impulse of the lock, impulses of spring, motor and limit).
#define JOINT_KEPT(X, of) \
	X(kept->impulse_##of, rare->of##_spring_impulse, rare->of##_motor_impulse, rare->of##_limit_impulse)

// Computes for each coordinate the sum of the impulses of lock, spring, motor and limit, as joint_sums.
INLINE void joint_sums_asleep(const Pools* p, int slot, int modes, float sum[JOINT_COORDINATES])
{
	const GLOBAL JointKept* kept = p->joint_kept + slot;
	const GLOBAL JointRareKept* rare = p->joint_rare_kept + slot;
	int k = 0;
#define SUM(lock, spring, motor, limit)                    \
	sum[k] = lock;                                         \
	if (p->step.has_drives && modes & JOINT_HAS_DRIVES(k)) \
		sum[k] = sum[k] + (spring + motor + limit);        \
	++k;
	JOINT_KEPT(SUM, along)
	JOINT_KEPT(SUM, across)
	JOINT_KEPT(SUM, angle)
#undef SUM
}

INLINE void joint_scale_asleep(const Pools* p, int slot, float part)
{
	GLOBAL JointKept* kept = p->joint_kept + slot;
	GLOBAL JointRareKept* rare = p->joint_rare_kept + slot;
#define SCALE(lock, spring, motor, limit) \
	lock = part * lock;                   \
	spring = part * spring;               \
	motor = part * motor;                 \
	limit = part * limit;
	JOINT_KEPT(SCALE, along)
	JOINT_KEPT(SCALE, across)
	JOINT_KEPT(SCALE, angle)
#undef SCALE
}

#endif
