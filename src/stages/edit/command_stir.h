// SPDX-License-Identifier: MIT
// command_stir.h -- decides which of the user's commands wake a body, and wakes it.
#ifndef COMMAND_STIR_H
#define COMMAND_STIR_H
#include "stages/edit/asleep.h"

// Returns whether a command wakes a sleeping body. Forces, impulses and velocities of 0 do not. A target belongs to a
// kinematic body, which never sleeps (command_target).
INLINE int command_stirs(const Pools* p, Command c)
{
	int xy = c.value.x != 0.0f || c.value.y != 0.0f;
	switch (c.kind)
	{
	case COMMAND_FORCE:
	case COMMAND_FORCE_AT:
	case COMMAND_TORQUE:
	case COMMAND_IMPULSE:
	case COMMAND_IMPULSE_AT:
	case COMMAND_ANGULAR_IMPULSE:
	case COMMAND_LINEAR_VELOCITY:
	case COMMAND_SPIN:
		return xy;
	case COMMAND_VELOCITY:
		return xy || c.value.z != 0.0f;
	case COMMAND_MASS:
	case COMMAND_JOINTS:
		return p->still[c.index] != STILL_MADE;
	case COMMAND_POSE:
	case COMMAND_MOTION:
	case COMMAND_ENABLED:
		return 1;
	case COMMAND_AWAKE:
		return c.whole[0];
	case COMMAND_SLEEP:
		return c.value.x < 0.0f;
	default:
		return 0;
	}
}

// Marks the island of a body that the user changes, and wakes the body itself at once, so that later commands act on
// it. joined: not 0 for a static or kinematic body with joints or fields: joint_wake marks the islands at these joints, and
// field_wake those in these fields.
INLINE void command_stir(const Pools* p, int i, int joined)
{
	if (p->sleep[i])
	{
		island_wake(p, i, WAKE_USER);
		body_rise(p, i);
		raise_int(&p->counters->touched, 0x7fffffff);
	}
	else if (joined)
		raise_int(&p->counters->woken, 0x7fffffff);
	p->still[i] = joined ? STILL_MOVED : STILL_STIRRED;
}

#endif
