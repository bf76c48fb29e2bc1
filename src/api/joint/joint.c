// SPDX-License-Identifier: MIT
// joint.c -- creates, destroys and lists joints.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/joint_check.h"
#include "world/objects/joints.h"
#include "world/record/api_calls.h"
#include <stdlib.h>

static scree_status check_end(const scree_world* world, ArgumentPlace at, const char* member, scree_body body,
                              int* index)
{
	*index = 0;
	return scree_body_is_null(body) ? SCREE_OK : check_body(world, at, member, body, index);
}

static scree_status check_def(const scree_world* world, ArgumentPlace at, const scree_joint_def* defs, int k,
                              scree_joint_def* made, int bodies[2])
{
	TRY(check_definition(at, defs, k, &joint_definition));
	*made = *(const scree_joint_def*)definition_at(defs, k, &joint_definition, made);
	if ((unsigned)made->type >= JOINT_TYPES)
		return refuse(SCREE_ERROR_INVALID, at, ".type", "is %d, not a scree_joint_type", (int)made->type);
	TRY(check_end(world, at, ".body_a", made->body_a, bodies));
	TRY(check_end(world, at, ".body_b", made->body_b, bodies + 1));
	if (bodies[0] == bodies[1])
		return refuse(SCREE_ERROR_INVALID, at, ".body_b",
		              "is body_a too: a joint needs two bodies, or one and the world");
	TRY(check_pose(at, ".frame_a", &made->frame_a));
	TRY(check_pose(at, ".frame_b", &made->frame_b));
	for (int c = 0; c < JOINT_COORDINATES; ++c)
		TRY(check_coordinate(at, made->type, (scree_coordinate)c, made->coordinates + c));
	TRY(check_motors(at, made));
	if (joint_couples(made->type))
		TRY(check_joint_coupling(at, made));
	int path;
	if (made->type == SCREE_JOINT_PATH)
	{
		TRY(check_path(world, at, ".path", made->path, &path));
		TRY(check_real(at, ".initial_along", made->initial_along, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE));
	}
	return check_joint_numbers(at, made);
}

bool scree_joint_is_valid(const scree_world* world, scree_joint joint) { return world && joint_is_valid(world, joint); }

static scree_status create(scree_world* world, const char* function, const char* argument, const scree_joint_def* defs,
                           int count, scree_joint* joints, bool alone)
{
	scree_joint_def made;
	int bodies[2];
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, defs, count));
	for (int k = 0; k < count; ++k)
		TRY(check_def(world, (ArgumentPlace){function, argument, alone ? ALONE : k}, defs, k, &made, bodies));
	TRY(joints_reserve(world, function, count));
	for (int k = 0; k < count; ++k)
	{
		check_def(world, (ArgumentPlace){function, argument, k}, defs, k, &made, bodies);
		int index = joint_put(world, &made, bodies[0], bodies[1]);
		if (joints)
			joints[k] = joint_handle(world, index);
	}
	return SCREE_OK;
}

scree_status api_joints_create(scree_world* world, const scree_joint_def* defs, int count, scree_joint* joints)
{
	FLOAT_MODE_HERE;
	return create(world, "scree_joints_create", "defs", defs, count, joints, false);
}

scree_status api_joint_create(scree_world* world, const scree_joint_def* def, scree_joint* joint)
{
	FLOAT_MODE_HERE;
	return create(world, "scree_joint_create", "def", def, 1, joint, true);
}

static scree_status destroy(scree_world* world, const char* function, const char* argument, const scree_joint* joints,
                            int count, bool alone)
{
	TRY(world_check(world, function));
	TRY(check_batch(function, argument, joints, count));
	scree_status status = SCREE_OK;
	int marked = 0;
	for (int index = 0; marked < count && status == SCREE_OK;)
	{
		ArgumentPlace at = {function, argument, alone ? ALONE : marked};
		status = check_joint(world, at, joints[marked], &index);
		if (status == SCREE_OK && world->host_joints[index].marked)
			status = refuse(SCREE_ERROR_STALE, at, "", "is twice in the batch");
		if (status == SCREE_OK)
		{
			world->host_joints[index].marked = true;
			++marked;
		}
	}
	for (int k = 0; k < marked; ++k)
		world->host_joints[joints[k].index - 1].marked = false;
	TRY(status);
	TRY(edits_reserve(world, function, 0, 0, JOINT_COMMANDS * count));
	for (int k = 0; k < count; ++k)
		joint_remove(world, (int)joints[k].index - 1);
	return SCREE_OK;
}

scree_status api_joints_destroy(scree_world* world, const scree_joint* joints, int count)
{
	FLOAT_MODE_HERE;
	return destroy(world, "scree_joints_destroy", "joints", joints, count, false);
}

scree_status api_joint_destroy(scree_world* world, scree_joint joint)
{
	FLOAT_MODE_HERE;
	return destroy(world, "scree_joint_destroy", "joint", &joint, 1, true);
}

// Lists the joints of a body, or all joints if `body` is -1. Returns the number of joints, which may exceed `capacity`.
static int list(const scree_world* world, int body, scree_joint* joints, int capacity)
{
	int listed = 0;
	for (int k = 0; k < world->joints.used; ++k)
	{
		const int* bodies = world->host_joints[k].bodies;
		if (!slots_in_use(&world->joints, k) || (body >= 0 && bodies[0] != body && bodies[1] != body))
			continue;
		if (listed < capacity)
			joints[listed] = joint_handle(world, k);
		++listed;
	}
	return listed;
}

scree_status api_world_get_joints(const scree_world* world, scree_joint* joints, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_joints";
	TRY(check_pointer(function, "world", world));
	TRY(check_list(function, "joints", joints, capacity, count));
	*count = list(world, -1, joints, capacity);
	return SCREE_OK;
}

static int compare_joints(const void* a, const void* b)
{
	uint32_t first = ((const scree_joint*)a)->index, second = ((const scree_joint*)b)->index;
	return first < second ? -1 : first > second;
}

scree_status api_body_get_joints(const scree_world* world, scree_body body, scree_joint* joints, int capacity,
                                 int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_joints";
	int index = 0, listed = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index));
	TRY(check_list(function, "joints", joints, capacity, count));
	// the list of a body has its newest joint first, so it is sorted; if `capacity` is too small for it, all joints of
	// the world are searched by index instead
	int total = 0;
	for (int end = world->host_bodies[index].first_joint; end > 0; end = joint_next(world, end))
		++total;
	if (total > capacity)
		listed = list(world, index, joints, capacity);
	else
	{
		for (int end = world->host_bodies[index].first_joint; end > 0; end = joint_next(world, end))
			joints[listed++] = joint_handle(world, joint_of_end(end));
		if (listed > 1)
			qsort(joints, (size_t)listed, sizeof *joints, compare_joints);
	}
	*count = total;
	return SCREE_OK;
}
