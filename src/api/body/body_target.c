// SPDX-License-Identifier: MIT
// body_target.c -- sets targets of kinematic bodies.
#include "platform/processor.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/targets.h"
#include "world/record/api_calls.h"
#include "world/world.h"

static scree_status check_target(const scree_world* world, ArgumentPlace body, ArgumentPlace value, scree_body handle,
                                 scree_pose* pose)
{
	static const char* const types[] = {"static", "kinematic", "dynamic"};
	int index = 0;
	TRY(check_body(world, body, "", handle, &index));
	scree_body_type type = world->host_bodies[index].type;
	if (type != SCREE_BODY_KINEMATIC)
		return refuse(SCREE_ERROR_INVALID, body, "", "is %s: only a kinematic body has a target", types[type]);
	return check_pose(value, "", pose);
}

static scree_status set(scree_world* world, const char* function, const char* body, const char* value,
                        const scree_body* bodies, const scree_pose* poses, int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, body, bodies, count));
	TRY(check_batch(function, value, poses, count));
	for (int k = 0; k < count; ++k)
	{
		scree_pose pose = poses[k];
		ArgumentPlace at = {function, body, alone ? ALONE : k};
		TRY(check_target(world, at, (ArgumentPlace){function, value, at.index}, bodies[k], &pose));
	}
	TRY(targets_reserve(world, function, count));
	for (int k = 0; k < count; ++k)
	{
		scree_pose pose = poses[k];
		check_pose((ArgumentPlace){function, value, k}, "", &pose); // normalizes the rotation
		target_put(world, (int)bodies[k].index, pose);
	}
	return SCREE_OK;
}

scree_status api_bodies_set_targets(scree_world* world, const scree_body* bodies, const scree_pose* poses, int count)
{
	FLOAT_MODE_HERE;
	return set(world, "scree_bodies_set_targets", "bodies", "poses", bodies, poses, count, false);
}

scree_status api_body_set_target(scree_world* world, scree_body body, scree_pose pose)
{
	FLOAT_MODE_HERE;
	return set(world, "scree_body_set_target", "body", "pose", &body, &pose, 1, true);
}
