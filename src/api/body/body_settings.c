// SPDX-License-Identifier: MIT
// body_settings.c -- sets and reads type, damping, gravity scale, locks, enabling and user word of a body.
#include "platform/processor.h"
#include "step/tree_maintenance.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/bodies.h"
#include "world/objects/collidables.h"
#include "world/objects/fields.h"
#include "world/objects/handles.h"
#include "world/objects/joints.h"
#include "world/objects/kinematics.h"
#include "world/objects/mass.h"
#include "world/objects/targets.h"
#include "world/record/api_calls.h"
#include "world/structure.h"
#include "world/upload/whole_sleep.h"
#include "world/world.h"

static scree_status lookup(const scree_world* world, const char* function, scree_body body, const char* argument,
                           const void* out, HostBody** host)
{
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index));
	*host = world->host_bodies + index;
	return check_pointer(function, argument, out);
}

static scree_status lookup_to_set(scree_world* world, const char* function, scree_body body, int commands, int* index)
{
	TRY(world_check(world, function));
	TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, index));
	commands += JOINT_COMMANDS * body_joint_count(world, *index);
	return edits_reserve(world, function, 0, world->host_bodies[*index].collidables, commands);
}

scree_status api_body_set_type(scree_world* world, scree_body body, scree_body_type type)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_type";
	int index = 0;
	TRY(lookup_to_set(world, function, body, 4, &index));
	TRY(check_type((ArgumentPlace){function, "type", ALONE}, "", type));
	HostBody* host = world->host_bodies + index;
	if (host->type == type)
		return SCREE_OK;
	TRY(kinematics_reserve(world, function, type == SCREE_BODY_KINEMATIC));
	int old_tree = tree_of_kind(kind_of_type(host->type)), new_tree = tree_of_kind(kind_of_type(type));
	for (int k = host->first_collidable; !host->disabled && k >= 0; k = world->host_collidables[k].next)
	{
		scree_status status = tree_insert(&world->pipeline, new_tree, k);
		if (status == SCREE_OK)
			continue;
		for (int done = host->first_collidable; done != k; done = world->host_collidables[done].next)
			tree_leave(&world->pipeline, new_tree, done);
		return status;
	}
	kinematic_drop(world, index);
	if (type == SCREE_BODY_KINEMATIC)
		kinematic_put(world, index);
	world->dynamic_bodies += (type == SCREE_BODY_DYNAMIC) - (host->type == SCREE_BODY_DYNAMIC);
	target_drop(world, index);
	host->type = type;
	host->still = false;
	for (int k = host->first_collidable; k >= 0; k = world->host_collidables[k].next)
	{
		edits_collidable(world, k);
		if (old_tree != new_tree && !host->disabled)
			tree_leave(&world->pipeline, old_tree, k);
	}
	if (type == SCREE_BODY_STATIC)
		edits_command(world, COMMAND_VELOCITY, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), 0);
	mass_set(world, index, mass_of_body(world, index));
	body_joints_changed(world, index);
	body_send_motion(world, index);
	return SCREE_OK;
}

scree_status api_body_get_type(const scree_world* world, scree_body body, scree_body_type* type)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_get_type", body, "type", type, &host));
	*type = host->type;
	return SCREE_OK;
}

scree_status api_body_set_damping(scree_world* world, scree_body body, float linear, float angular)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_damping";
	int index = 0;
	TRY(lookup_to_set(world, function, body, 1, &index));
	TRY(check_linear_damping((ArgumentPlace){function, "linear", ALONE}, "", linear));
	TRY(check_angular_damping((ArgumentPlace){function, "angular", ALONE}, "", angular));
	HostBody* host = world->host_bodies + index;
	if (host->values.linear_damping == linear && host->values.angular_damping == angular)
		return SCREE_OK; // so that a call in each step keeps no body awake
	host->values.linear_damping = linear;
	host->values.angular_damping = angular;
	body_send_motion(world, index);
	return SCREE_OK;
}

scree_status api_body_get_damping(const scree_world* world, scree_body body, float* linear, float* angular)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_damping";
	HostBody* host;
	TRY(lookup(world, function, body, "linear", linear, &host));
	TRY(check_pointer(function, "angular", angular));
	*linear = host->values.linear_damping;
	*angular = host->values.angular_damping;
	return SCREE_OK;
}

scree_status api_body_set_gravity_scale(scree_world* world, scree_body body, float scale)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_gravity_scale";
	int index = 0;
	TRY(lookup_to_set(world, function, body, 1, &index));
	TRY(check_gravity_scale((ArgumentPlace){function, "scale", ALONE}, "", scale));
	if (world->host_bodies[index].values.gravity_scale == scale)
		return SCREE_OK;
	world->host_bodies[index].values.gravity_scale = scale;
	body_send_motion(world, index);
	return SCREE_OK;
}

scree_status api_body_get_gravity_scale(const scree_world* world, scree_body body, float* scale)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_get_gravity_scale", body, "scale", scale, &host));
	*scale = host->values.gravity_scale;
	return SCREE_OK;
}

scree_status api_body_set_locks(scree_world* world, scree_body body, uint32_t locks)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_set_locks";
	int index = 0;
	TRY(lookup_to_set(world, function, body, 3, &index));
	TRY(check_locks((ArgumentPlace){function, "locks", ALONE}, "", locks));
	if (world->host_bodies[index].locks == locks)
		return SCREE_OK;
	mass_settle(world);
	world->host_bodies[index].locks = locks;
	mass_set(world, index, world->host_bodies[index].mass);
	body_send_motion(world, index);
	return SCREE_OK;
}

scree_status api_body_get_locks(const scree_world* world, scree_body body, uint32_t* locks)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_get_locks", body, "locks", locks, &host));
	*locks = host->locks;
	return SCREE_OK;
}

// Inserts the leaves of the disabled bodies that a batch enables. On failure, removes the inserted leaves.
static scree_status insert_batch(scree_world* world, const scree_body* bodies, const bool* enabled, int count)
{
	scree_status status = SCREE_OK;
	int done = 0;
	for (; done < count && status == SCREE_OK; ++done)
	{
		const HostBody* host = world->host_bodies + bodies[done].index;
		if (enabled[done] && host->disabled)
			status = body_insert_leaves(world, host);
	}
	for (int k = 0; k < done && status != SCREE_OK; ++k)
	{
		const HostBody* host = world->host_bodies + bodies[k].index;
		if (enabled[k] && host->disabled)
			body_remove_leaves(world, host);
	}
	return status;
}

// Enables or disables a body. The caller has reserved memory for edits and, to enable a body, inserted its leaves.
static void enable(scree_world* world, int index, bool enabled)
{
	HostBody* host = world->host_bodies + index;
	if (host->disabled == !enabled)
		return;
	if (enabled)
		body_insert_leaves(world, host); // inserts leaves only if an earlier entry of the batch disabled the body
	else
		body_remove_leaves(world, host);
	host->disabled = !enabled;
	world->disabled_bodies += enabled ? -1 : 1;
	for (int k = host->first_collidable; k >= 0; k = world->host_collidables[k].next)
	{
		world->host_collidables[k].born = world->pipeline.steps;
		edits_collidable(world, k);
	}
	body_joints_changed(world, index);
	fields_body_changed(world, index);
	edits_command(world, COMMAND_ENABLED, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), enabled);
	body_send_motion(world, index);
}

static scree_status set_enabled(scree_world* world, const char* function, const char* argument,
                                const scree_body* bodies, const bool* enabled, int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, bodies, count));
	TRY(check_batch(function, "enabled", enabled, count));
	int index = 0, collidables = 0, joints = 0;
	bool fields = false;
	for (int k = 0; k < count; ++k)
	{
		TRY(check_body(world, (ArgumentPlace){function, argument, alone ? ALONE : k}, "", bodies[k], &index));
		collidables += world->host_bodies[index].collidables;
		joints += body_joint_count(world, index);
		fields |= world->host_bodies[index].fields > 0;
	}
	TRY(edits_reserve(world, function, 0, collidables, 2 * count + JOINT_COMMANDS * joints));
	if (fields)
		TRY(world_set_awake(world, true));
	TRY(insert_batch(world, bodies, enabled, count));
	for (int k = 0; k < count; ++k)
		enable(world, (int)bodies[k].index, enabled[k]);
	return SCREE_OK;
}

scree_status api_bodies_set_enabled(scree_world* world, const scree_body* bodies, const bool* enabled, int count)
{
	FLOAT_MODE_HERE;
	return set_enabled(world, "scree_bodies_set_enabled", "bodies", bodies, enabled, count, false);
}

scree_status api_body_set_enabled(scree_world* world, scree_body body, bool enabled)
{
	FLOAT_MODE_HERE;
	return set_enabled(world, "scree_body_set_enabled", "body", &body, &enabled, 1, true);
}

bool scree_body_is_enabled(const scree_world* world, scree_body body)
{
	return scree_body_is_valid(world, body) && !world->host_bodies[body.index].disabled;
}

scree_status api_body_set_user(scree_world* world, scree_body body, uint64_t user)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_set_user", body, "user", &user, &host));
	host->user = user;
	structure_changed(world);
	return SCREE_OK;
}

scree_status api_body_get_user(const scree_world* world, scree_body body, uint64_t* user)
{
	FLOAT_MODE_HERE;
	HostBody* host;
	TRY(lookup(world, "scree_body_get_user", body, "user", user, &host));
	*user = host->user;
	return SCREE_OK;
}
