// SPDX-License-Identifier: MIT
// scree_world.c -- lists of what a Scree world has, and the errors of Scree.
#include "scree_world.h"
#include <stdio.h>
#include <stdlib.h>

bool report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree_peers: %s\n", scree_error());
	return status == SCREE_OK;
}

scree_body* list_bodies(const scree_world* world, int* count)
{
	*count = 0;
	scree_world_get_bodies(world, NULL, 0, count);
	scree_body* bodies = malloc(((size_t)*count + 1) * sizeof(scree_body));
	if (bodies)
		scree_world_get_bodies(world, bodies, *count, count);
	else
		fprintf(stderr, "scree_peers: no memory for %d bodies\n", *count);
	return bodies;
}

scree_joint* list_joints(const scree_world* world, int* count)
{
	*count = 0;
	scree_world_get_joints(world, NULL, 0, count);
	scree_joint* joints = malloc(((size_t)*count + 1) * sizeof(scree_joint));
	if (joints)
		scree_world_get_joints(world, joints, *count, count);
	else
		fprintf(stderr, "scree_peers: no memory for %d joints\n", *count);
	return joints;
}
