// SPDX-License-Identifier: MIT
// kinematics.c -- the list of a world's kinematic bodies: if few, continuous collision compares paths with each.
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

// Removes a body; the last one takes its place.
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
