// SPDX-License-Identifier: MIT
// joint_settings.c -- sets and reads settings of one joint.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/joint_check.h"
#include "world/objects/joints.h"
#include "world/record/api_calls.h"
#include "world/structure.h"
#include <float.h>
#include <string.h>

static scree_status lookup(scree_world* world, const char* function, scree_joint joint, int* index)
{
	TRY(world_check(world, function));
	TRY(check_joint(world, (ArgumentPlace){function, "joint", ALONE}, joint, index));
	return edits_reserve(world, function, 0, 0, JOINT_COMMANDS);
}

// Records the change of a joint, unless its definition is as before, so that a call in each step keeps no body awake.
static void record(scree_world* world, int index, const scree_joint_def* before)
{
	if (memcmp(before, &world->host_joints[index].def, sizeof *before) != 0)
		joint_changed(world, index, false);
}

scree_status api_joint_set_stiffness(scree_world* world, scree_joint joint, float hertz, float damping_ratio)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joint_set_stiffness";
	int index = 0;
	TRY(lookup(world, function, joint, &index));
	TRY(check_real((ArgumentPlace){function, "hertz", ALONE}, "", hertz, 0.0f, 1e6f));
	TRY(check_real((ArgumentPlace){function, "damping_ratio", ALONE}, "", damping_ratio, 0.0f, 1e6f));
	const scree_joint_def before = world->host_joints[index].def;
	world->host_joints[index].def.hertz = hertz;
	world->host_joints[index].def.damping_ratio = damping_ratio;
	record(world, index, &before);
	return SCREE_OK;
}

static scree_status lookup_coupling(scree_world* world, const char* function, scree_joint joint, int* index)
{
	TRY(lookup(world, function, joint, index));
	scree_joint_type type = world->host_joints[*index].def.type;
	if (joint_couples(type))
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "joint", ALONE}, "",
	              "is of type %s, not a gear or a pulley", scree_joint_type_name(type));
}

scree_status api_joint_set_ratio(scree_world* world, scree_joint joint, float ratio)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joint_set_ratio";
	int index = 0;
	TRY(lookup_coupling(world, function, joint, &index));
	TRY(check_gear_ratio((ArgumentPlace){function, "ratio", ALONE}, "", ratio));
	const scree_joint_def before = world->host_joints[index].def;
	world->host_joints[index].def.ratio = ratio;
	record(world, index, &before);
	return SCREE_OK;
}

scree_status api_joint_set_bases(scree_world* world, scree_joint joint, scree_pose base_a, scree_pose base_b)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joint_set_bases";
	int index = 0;
	TRY(lookup_coupling(world, function, joint, &index));
	TRY(check_pose((ArgumentPlace){function, "base_a", ALONE}, "", &base_a));
	TRY(check_pose((ArgumentPlace){function, "base_b", ALONE}, "", &base_b));
	const scree_joint_def before = world->host_joints[index].def;
	world->host_joints[index].def.sides[0].base = base_a;
	world->host_joints[index].def.sides[1].base = base_b;
	record(world, index, &before);
	return SCREE_OK;
}

scree_status api_joint_set_thresholds(scree_world* world, scree_joint joint, float force, float torque, bool can_break)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joint_set_thresholds";
	int index = 0;
	TRY(lookup(world, function, joint, &index));
	TRY(check_real((ArgumentPlace){function, "force", ALONE}, "", force, 0.0f, FLT_MAX));
	TRY(check_real((ArgumentPlace){function, "torque", ALONE}, "", torque, 0.0f, FLT_MAX));
	HostJoint* host = world->host_joints + index;
	const scree_joint_def before = host->def;
	host->def.force_threshold = force;
	host->def.torque_threshold = torque;
	host->def.can_break = can_break;
	record(world, index, &before);
	return SCREE_OK;
}

scree_status api_joint_set_elliptic(scree_world* world, scree_joint joint, bool elliptic)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_joint_set_elliptic", joint, &index));
	const scree_joint_def before = world->host_joints[index].def;
	world->host_joints[index].def.elliptic = elliptic;
	record(world, index, &before);
	return SCREE_OK;
}

scree_status api_joint_set_collide_connected(scree_world* world, scree_joint joint, bool collides)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_joint_set_collide_connected", joint, &index));
	const scree_joint_def before = world->host_joints[index].def;
	world->host_joints[index].def.collide_connected = collides;
	record(world, index, &before);
	return SCREE_OK;
}

scree_status api_joint_set_user(scree_world* world, scree_joint joint, uint64_t user)
{
	FLOAT_MODE_HERE;
	int index = 0;
	TRY(lookup(world, "scree_joint_set_user", joint, &index));
	world->host_joints[index].def.user = user;
	structure_changed(world);
	return SCREE_OK;
}

scree_status api_joint_get_def_sized(const scree_world* world, scree_joint joint, scree_joint_def* def, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joint_get_def";
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_joint(world, (ArgumentPlace){function, "joint", ALONE}, joint, &index));
	TRY(check_pointer(function, "def", def));
	scree_joint_def now = world->host_joints[index].def;
	now.size = (uint32_t)size;
	write_result(def, size, &now, sizeof now);
	return SCREE_OK;
}
