// SPDX-License-Identifier: MIT
// joint_ends.h -- links the joints of a body to a list of ends. Joint k has two ends, one per body: 2 k and 2 k + 1.
#ifndef JOINT_ENDS_H
#define JOINT_ENDS_H
#include "world/world.h"

// Return the joint of an end, and the next end in the list of its body. Ends are passed as 1 + end, 0 for none.
static inline int joint_of_end(int end) { return (end - 1) / 2; }
static inline int joint_next(const scree_world* world, int end)
{
	return world->host_joints[joint_of_end(end)].next[(end - 1) % 2];
}

#endif
