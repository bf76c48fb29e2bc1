// SPDX-License-Identifier: MIT
// body_motion.c -- sets forces, impulses, velocities and poses of one body or a batch of bodies, by commands.
#include "platform/processor.h"
#include "step/tree_maintenance.h"
#include "world/check.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/bodies.h"
#include "world/objects/collidables.h"
#include "world/objects/handles.h"
#include "world/objects/joints.h"
#include "world/objects/mass.h"
#include "world/objects/targets.h"
#include "world/pool_values.h"
#include "world/record/api_calls.h"
#include "world/world.h"

typedef struct // a call of the user: its name, the kind of its command, and the names of its arguments
{
	const char* function;
	int kind; // one of COMMAND_*
	const char* values;
	const char* points; // null if the call has no points
	bool alone;         // true: the call is for a single body, so messages contain "body" and no index
} Call;

typedef struct // values of a call: one array is set, the others are null; only `vectors` may have `points` in addition
{
	const float* numbers;
	const scree_vec* vectors;
	const scree_vec* points;
	const scree_velocity* velocities;
	const scree_pose* poses;
} Values;

static const void* values_array(const Values* v)
{
	if (v->numbers)
		return v->numbers;
	if (v->vectors)
		return v->vectors;
	return v->velocities ? (const void*)v->velocities : (const void*)v->poses;
}

static scree_status value_at(const Call* call, const Values* values, int k, Float4* value)
{
	int shown = call->alone ? ALONE : k;
	ArgumentPlace at = {call->function, call->values, shown};
	float limit = call->kind == COMMAND_LINEAR_VELOCITY || call->kind == COMMAND_SPIN ? SCREE_MAX_COORDINATE : FLT_MAX;
	if (values->numbers)
	{
		*value = make_float4(values->numbers[k], 0.0f, 0.0f, 0.0f);
		return check_real(at, "", values->numbers[k], -limit, limit);
	}
	if (values->vectors)
	{
		scree_vec v = values->vectors[k], p = values->points ? values->points[k] : (scree_vec){0};
		*value = make_float4(v.x, v.y, p.x, p.y);
		TRY(check_vec(at, "", v, limit));
		return check_vec((ArgumentPlace){call->function, call->points, shown}, "", p, SCREE_MAX_COORDINATE);
	}
	if (values->velocities)
	{
		scree_velocity v = values->velocities[k];
		*value = make_float4(v.linear.x, v.linear.y, v.angular, 0.0f);
		return check_velocity(at, "", v);
	}
	scree_pose pose = values->poses[k];
	scree_status status = check_pose(at, "", &pose);
	*value = pose_row(pose);
	return status;
}

// Only the members of kinematic bodies are a part of each save.
static void note_velocity(scree_world* world, int index)
{
	HostBody* host = world->host_bodies + index;
	target_drop(world, index);
	host->still &= host->type != SCREE_BODY_KINEMATIC;
}

static void send(scree_world* world, int kind, int index, Float4 value)
{
	const HostBody* host = world->host_bodies + index;
	if (kind == COMMAND_VELOCITY || kind == COMMAND_LINEAR_VELOCITY)
	{
		scree_velocity v = body_velocity_allowed(host, (scree_velocity){{value.x, value.y}, value.z});
		value = make_float4(v.linear.x, v.linear.y, v.angular, 0.0f);
		note_velocity(world, index);
	}
	else if (kind == COMMAND_SPIN)
	{
		value.x = body_velocity_allowed(host, (scree_velocity){.angular = value.x}).angular;
		note_velocity(world, index);
	}
	else if (kind == COMMAND_POSE)
	{
		world->host_bodies[index].stands = (scree_pose){{value.x, value.y}, {value.z, value.w}};
		world->host_bodies[index].went = -1;
		body_joints_seek(world, index);
		if (host->type == SCREE_BODY_STATIC && host->collidables > 0)
			tree_touch(&world->pipeline, tree_of_kind(KIND_STATIC));
	}
	else if (host->type != SCREE_BODY_DYNAMIC)
		return;
	edits_command(world, kind, index, value, 0);
}

static scree_status change(scree_world* world, const Call* call, const scree_body* bodies, const Values* values,
                           int count)
{
	const char* name = call->alone ? "body" : "bodies";
	TRY(world_check(world, call->function));
	TRY(check_batch(call->function, name, bodies, count));
	TRY(check_batch(call->function, call->values, values_array(values), count));
	if (call->points)
		TRY(check_batch(call->function, call->points, values->points, count));
	int index = 0;
	Float4 value;
	for (int k = 0; k < count; ++k)
	{
		TRY(check_body(world, (ArgumentPlace){call->function, name, call->alone ? ALONE : k}, "", bodies[k], &index));
		TRY(value_at(call, values, k, &value));
	}
	int joints = 0;
	for (int k = 0; k < count && call->kind == COMMAND_POSE && world->paths.alive > 0; ++k)
		joints += body_joint_count(world, (int)bodies[k].index);
	TRY(edits_reserve(world, call->function, 0, 0, count + JOINT_COMMANDS * joints));
	mass_settle(world); // impulses depend on the inertia, so pending masses are computed first
	for (int k = 0; k < count; ++k)
	{
		value_at(call, values, k, &value);
		send(world, call->kind, (int)bodies[k].index, value);
	}
	return SCREE_OK;
}

scree_status api_bodies_apply_forces(scree_world* world, const scree_body* bodies, const scree_vec* forces, int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_apply_forces", COMMAND_FORCE, "forces", NULL, false};
	return change(world, &call, bodies, &(Values){.vectors = forces}, count);
}

scree_status api_bodies_apply_torques(scree_world* world, const scree_body* bodies, const float* torques, int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_apply_torques", COMMAND_TORQUE, "torques", NULL, false};
	return change(world, &call, bodies, &(Values){.numbers = torques}, count);
}

scree_status api_bodies_apply_impulses(scree_world* world, const scree_body* bodies, const scree_vec* impulses,
                                       int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_apply_impulses", COMMAND_IMPULSE, "impulses", NULL, false};
	return change(world, &call, bodies, &(Values){.vectors = impulses}, count);
}

scree_status api_bodies_apply_angular_impulses(scree_world* world, const scree_body* bodies, const float* impulses,
                                               int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_apply_angular_impulses", COMMAND_ANGULAR_IMPULSE, "impulses", NULL, false};
	return change(world, &call, bodies, &(Values){.numbers = impulses}, count);
}

scree_status api_bodies_apply_forces_at(scree_world* world, const scree_body* bodies, const scree_vec* forces,
                                        const scree_vec* points, int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_apply_forces_at", COMMAND_FORCE_AT, "forces", "points", false};
	return change(world, &call, bodies, &(Values){.vectors = forces, .points = points}, count);
}

scree_status api_bodies_apply_impulses_at(scree_world* world, const scree_body* bodies, const scree_vec* impulses,
                                          const scree_vec* points, int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_apply_impulses_at", COMMAND_IMPULSE_AT, "impulses", "points", false};
	return change(world, &call, bodies, &(Values){.vectors = impulses, .points = points}, count);
}

scree_status api_bodies_set_velocities(scree_world* world, const scree_body* bodies, const scree_velocity* velocities,
                                       int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_set_velocities", COMMAND_VELOCITY, "velocities", NULL, false};
	return change(world, &call, bodies, &(Values){.velocities = velocities}, count);
}

scree_status api_bodies_set_linear_velocities(scree_world* world, const scree_body* bodies, const scree_vec* velocities,
                                              int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_set_linear_velocities", COMMAND_LINEAR_VELOCITY, "velocities", NULL, false};
	return change(world, &call, bodies, &(Values){.vectors = velocities}, count);
}

scree_status api_bodies_set_angular_velocities(scree_world* world, const scree_body* bodies, const float* velocities,
                                               int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_set_angular_velocities", COMMAND_SPIN, "velocities", NULL, false};
	return change(world, &call, bodies, &(Values){.numbers = velocities}, count);
}

scree_status api_bodies_set_poses(scree_world* world, const scree_body* bodies, const scree_pose* poses, int count)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_bodies_set_poses", COMMAND_POSE, "poses", NULL, false};
	return change(world, &call, bodies, &(Values){.poses = poses}, count);
}

scree_status api_body_apply_force(scree_world* world, scree_body body, scree_vec force)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_apply_force", COMMAND_FORCE, "force", NULL, true};
	return change(world, &call, &body, &(Values){.vectors = &force}, 1);
}

scree_status api_body_apply_force_at(scree_world* world, scree_body body, scree_vec force, scree_vec point)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_apply_force_at", COMMAND_FORCE_AT, "force", "point", true};
	return change(world, &call, &body, &(Values){.vectors = &force, .points = &point}, 1);
}

scree_status api_body_apply_torque(scree_world* world, scree_body body, float torque)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_apply_torque", COMMAND_TORQUE, "torque", NULL, true};
	return change(world, &call, &body, &(Values){.numbers = &torque}, 1);
}

scree_status api_body_apply_impulse(scree_world* world, scree_body body, scree_vec impulse)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_apply_impulse", COMMAND_IMPULSE, "impulse", NULL, true};
	return change(world, &call, &body, &(Values){.vectors = &impulse}, 1);
}

scree_status api_body_apply_impulse_at(scree_world* world, scree_body body, scree_vec impulse, scree_vec point)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_apply_impulse_at", COMMAND_IMPULSE_AT, "impulse", "point", true};
	return change(world, &call, &body, &(Values){.vectors = &impulse, .points = &point}, 1);
}

scree_status api_body_apply_angular_impulse(scree_world* world, scree_body body, float impulse)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_apply_angular_impulse", COMMAND_ANGULAR_IMPULSE, "impulse", NULL, true};
	return change(world, &call, &body, &(Values){.numbers = &impulse}, 1);
}

scree_status api_body_set_velocity(scree_world* world, scree_body body, scree_velocity velocity)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_set_velocity", COMMAND_VELOCITY, "velocity", NULL, true};
	return change(world, &call, &body, &(Values){.velocities = &velocity}, 1);
}

scree_status api_body_set_linear_velocity(scree_world* world, scree_body body, scree_vec velocity)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_set_linear_velocity", COMMAND_LINEAR_VELOCITY, "velocity", NULL, true};
	return change(world, &call, &body, &(Values){.vectors = &velocity}, 1);
}

scree_status api_body_set_angular_velocity(scree_world* world, scree_body body, float velocity)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_set_angular_velocity", COMMAND_SPIN, "velocity", NULL, true};
	return change(world, &call, &body, &(Values){.numbers = &velocity}, 1);
}

scree_status api_body_set_pose(scree_world* world, scree_body body, scree_pose pose)
{
	FLOAT_MODE_HERE;
	static const Call call = {"scree_body_set_pose", COMMAND_POSE, "pose", NULL, true};
	return change(world, &call, &body, &(Values){.poses = &pose}, 1);
}
