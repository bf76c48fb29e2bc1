// SPDX-License-Identifier: MIT
// kinematics.c -- keeps the list of kinematic bodies. Continuous collision tests all of them if they are few.
#include "world/objects/kinematics.h"
#include "world/memory.h"
#include "world/world.h"

scree_status kinematics_reserve(scree_world* world, const char* function, int more)
{
	return GROW(function, world->kinematics, world->kinematic_capacity, world->kinematic_count + more);
}

void kinematic_put(scree_world* world, int body)
{
	world->kinematics[world->kinematic_count] = body;
	world->host_bodies[body].kinematic = ++world->kinematic_count;
}

void kinematic_drop(scree_world* world, int body)
{
	HostBody* host = world->host_bodies + body;
	if (host->kinematic == 0)
		return;
	int last = world->kinematics[--world->kinematic_count];
	world->kinematics[host->kinematic - 1] = last;
	world->host_bodies[last].kinematic = host->kinematic;
	host->kinematic = 0;
}
