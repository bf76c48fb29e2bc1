// SPDX-License-Identifier: MIT
// joint_ends.h -- the list of a body's joints.
//
// Each joint has two ends, of its two bodies: end 2 k + 0 and 2 k + 1 of joint k. The lists of bodies link ends.
#ifndef JOINT_ENDS_H
#define JOINT_ENDS_H
#include "world/world.h"

// The joint of an end, and the next end in the list of its body, as 1 + end; 0 for none. HostBody.first_joint is the first.
static inline int joint_of_end(int end) { return (end - 1) / 2; }
static inline int joint_next(const scree_world* world, int end)
{
	return world->host_joints[joint_of_end(end)].next[(end - 1) % 2];
}

#endif
