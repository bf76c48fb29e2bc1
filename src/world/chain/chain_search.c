// SPDX-License-Identifier: MIT
// chain_search.c -- decides which joints may belong to chains and branches.
#include "world/chain/chain_search.h"
#include "world/objects/joints.h"

bool chain_acts(const scree_world* world, int joint)
{
	const HostJoint* host = world->host_joints + joint;
	bool moves = false, locks = false;
	if (!slots_in_use(&world->joints, joint) || host->def.disabled || joint_couples(host->def.type) || host->path >= 0)
		return false;
	for (int side = 0; side < 2; ++side)
	{
		const HostBody* body = world->host_bodies + host->bodies[side];
		if (body->disabled)
			return false;
		moves |= body->type == SCREE_BODY_DYNAMIC;
	}
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		locks |= host->def.coordinates[k].locked;
	return moves && locks;
}
