// SPDX-License-Identifier: MIT
// bodies.c -- computes values that depend on the type and the locks of a body.
#include "world/objects/bodies.h"
#include "platform/error.h"
#include "step/tree_maintenance.h"
#include "world/edits.h"
#include "world/objects/collidables.h"
#include "world/pool_values.h"

scree_velocity body_velocity_allowed(const HostBody* host, scree_velocity velocity)
{
	if (host->type == SCREE_BODY_STATIC)
		return (scree_velocity){0};
	if (host->locks & SCREE_LOCK_X)
		velocity.linear.x = 0.0f;
	if (host->locks & SCREE_LOCK_Y)
		velocity.linear.y = 0.0f;
	if (host->locks & SCREE_LOCK_ROTATION)
		velocity.angular = 0.0f;
	return velocity;
}

void body_send_motion(scree_world* world, int index)
{
	const HostBody* host = world->host_bodies + index;
	BodyValues none = {0};
	Float4 values = body_values_row(host->type == SCREE_BODY_DYNAMIC ? &host->values : &none);
	edits_command(world, COMMAND_MOTION, index, values, (int)host->locks);
}

scree_status body_insert_leaves(scree_world* world, const HostBody* host)
{
	int tree = tree_of_kind(kind_of_type(host->type));
	for (int k = host->first_collidable; k >= 0; k = world->host_collidables[k].next)
		TRY(tree_insert(&world->pipeline, tree, k));
	return SCREE_OK;
}

void body_remove_leaves(scree_world* world, const HostBody* host)
{
	int tree = tree_of_kind(kind_of_type(host->type));
	for (int k = host->first_collidable; k >= 0; k = world->host_collidables[k].next)
		tree_leave(&world->pipeline, tree, k);
}
