// SPDX-License-Identifier: MIT
// scree_world.c -- reads the bodies and joints of a Scree world, and prints the errors of Scree.
#include "scree_world.h"
#include <stdio.h>
#include <stdlib.h>

bool report_status(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree: %s\n", scree_error());
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
		fprintf(stderr, "scree: no memory for %d bodies\n", *count);
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
		fprintf(stderr, "scree: no memory for %d joints\n", *count);
	return joints;
}

static bool read_part(const scree_world* world, scree_collidable collidable, EnginePart* part)
{
	scree_attribute attribute;
	scree_pose pose;
	scree_shape shape;
	if (!report_status(scree_collidable_get_attribute(world, collidable, &attribute)) ||
	    !report_status(scree_attribute_get_def(world, attribute, &part->surface)) ||
	    !report_status(scree_collidable_get_local_pose(world, collidable, &pose)) ||
	    !report_status(scree_collidable_get_filter(world, collidable, &part->filter)) ||
	    !report_status(scree_shape_transform(&part->surface.shape, pose, &shape)))
		return false;
	part->surface.shape = shape;
	return true;
}

static bool read_parts(scree_world* world, scree_body handle, EngineBody* body)
{
	scree_collidable* collidables = malloc(((size_t)body->count + 1) * sizeof *collidables);
	body->parts = malloc(((size_t)body->count + 1) * sizeof *body->parts);
	bool good = collidables && body->parts;
	if (!good)
		fprintf(stderr, "scree: no memory for %d collidables\n", body->count);
	good = good && report_status(scree_body_get_collidables(world, handle, collidables, body->count, &body->count));
	for (int k = 0; good && k < body->count; ++k)
		good = read_part(world, collidables[k], &body->parts[k]);
	free(collidables);
	return good;
}

bool read_body(scree_world* world, scree_body handle, EngineBody* body)
{
	*body = (EngineBody){.index = (int)handle.index};
	return report_status(scree_body_get_def(world, handle, &body->def)) &&
	       report_status(scree_body_get_collidables(world, handle, NULL, 0, &body->count)) &&
	       read_parts(world, handle, body);
}
