// SPDX-License-Identifier: MIT
// own_host.c -- gives the host data of a template the own values of one of its worlds.
#include "batch/own_host.h"
#include "platform/error.h"
#include "world/objects/mass.h"
#include <string.h>

scree_status own_host_open(scree_world** made, const scree_world* world)
{
	*made = scree_allocate(sizeof **made);
	if (*made)
	{
		**made = *world;
		(*made)->host_bodies = scree_allocate(sizeof *world->host_bodies * ((size_t)world->bodies.used + 1));
		(*made)->host_joints = scree_allocate(sizeof *world->host_joints * ((size_t)world->joints.used + 1));
		if ((*made)->host_bodies && (*made)->host_joints)
			return SCREE_OK;
	}
	own_host_close(*made);
	*made = NULL;
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d bodies and %d joints", world->bodies.used,
	            world->joints.used);
}

void own_host_close(scree_world* made)
{
	if (!made)
		return;
	scree_release(made->host_bodies);
	scree_release(made->host_joints);
	scree_release(made);
}

void own_host_set(scree_world* made, const Template* from, Own own)
{
	const scree_world* world = from->world;
	Own template = own_of(from, from->own);
	int joints = world->joints.used < own.joints ? world->joints.used : own.joints;
	memcpy(made->host_bodies, world->host_bodies, sizeof *made->host_bodies * (size_t)own.bodies);
	if (world->joints.used > 0) // else there is no array
		memcpy(made->host_joints, world->host_joints, sizeof *made->host_joints * (size_t)world->joints.used);
	for (int k = 0; k < own.bodies; ++k)
	{
		HostBody* host = made->host_bodies + k;
		host->disabled = own.body[k].disabled != 0;
		if (memcmp(&own.body[k].mass, &template.body[k].mass, sizeof host->own_mass) == 0)
			continue;
		host->own_mass = own.body[k].mass;
		host->mass = mass_of_body(made, k);
		host->arm = mass_arm(made, host);
	}
	for (int k = 0; k < joints; ++k)
		made->host_joints[k].def.disabled = (own.joint[k] & OWN_JOINT_DISABLED) != 0;
}
