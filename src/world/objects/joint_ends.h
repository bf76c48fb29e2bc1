// SPDX-License-Identifier: MIT
// joint_ends.h -- reads the list of the joint ends of a body. Joint k has two ends, one per body: 2 k and 2 k + 1.
#ifndef JOINT_ENDS_H
#define JOINT_ENDS_H
#include "world/world.h"

// Return the joint of an end, and the next end in the list of its body. An end is given as 1 + its number; 0 is no end.
static inline int joint_of_end(int end) { return (end - 1) / 2; }
static inline int joint_next(const scree_world* world, int end)
{
	return world->host_joints[joint_of_end(end)].next[(end - 1) % 2];
}

#endif
