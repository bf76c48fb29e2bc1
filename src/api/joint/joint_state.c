// SPDX-License-Identifier: MIT
// joint_state.c -- reads coordinates, forces and events of joints from the device.
#include "api/joint/joint_state.h"
#include "platform/processor.h"
#include "step/state_readback.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"
#include <stdlib.h>

static scree_joint_state state_of(const JointState* row)
{
	scree_joint_state state = {.force = {row->force_x, row->force_y}, .torque = row->torque, .broken = row->broken};
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		state.values[k] = row->value[k];
		state.speeds[k] = row->speed[k];
	}
	return state;
}

// Computes and reads the states of all joints between the lowest and the highest index of the batch, in one read.
scree_status api_joints_get_states_sized(scree_world* world, const scree_joint* joints, scree_joint_state* states,
                                         size_t size, int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joints_get_states";
	int low = 0, high = 0;
	TRY(world_check(world, function));
	TRY(check_batch(function, "joints", joints, count));
	TRY(check_batch(function, "states", states, count));
	for (int k = 0, index = 0; k < count; ++k)
	{
		TRY(check_joint(world, (ArgumentPlace){function, "joints", k}, joints[k], &index));
		low = k == 0 || index < low ? index : low;
		high = index > high ? index : high;
	}
	if (count == 0)
		return SCREE_OK;
	TRY(world_upload(world));
	JointState* rows = world_scratch(world, (size_t)(high - low + 1) * sizeof *rows);
	if (!rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d joints", function, high - low + 1);
	TRY(world_note(world, pipeline_report_joints(&world->pipeline, low, high - low + 1)));
	TRY(world_read(world, POOL_joint_state, low, high - low + 1, rows));
	for (int k = 0; k < count; ++k)
	{
		scree_joint_state state = state_of(rows + ((int)joints[k].index - 1 - low));
		write_result((char*)states + size * (size_t)k, size, &state, sizeof state);
	}
	return SCREE_OK;
}

static int compare_events(const void* a, const void* b)
{
	return ((const JointEvent*)a)->slot - ((const JointEvent*)b)->slot;
}

scree_status joint_events_find(scree_world* world, const char* function, JointEvent** rows, int* count)
{
	*count = 0;
	if (!world->pipeline.has_drives)
		return SCREE_OK;
	TRY(world_read(world, POOL_counters, 0, 1, &world->pipeline.counters));
	int found = world->pipeline.counters.joint_events;
	if (found == 0)
		return SCREE_OK;
	*rows = world_scratch(world, (size_t)found * sizeof **rows);
	if (!*rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d events", function, found);
	TRY(world_read(world, POOL_joint_event, 0, found, *rows));
	qsort(*rows, (size_t)found, sizeof **rows, compare_events);
	for (int k = 0; k < found; ++k)
	{
		int slot = (*rows)[k].slot;
		if (slots_in_use(&world->joints, slot) && world->host_joints[slot].born < world->pipeline.steps)
			(*rows)[(*count)++] = (*rows)[k];
	}
	return SCREE_OK;
}

scree_joint_event joint_event_result(const scree_world* world, const JointEvent* row)
{
	return (scree_joint_event){.joint = joint_handle(world, row->slot),
	                           .force = row->force,
	                           .torque = row->torque,
	                           .broken = row->broken,
	                           .user = world->host_joints[row->slot].def.user};
}

scree_status api_world_get_joint_events_sized(scree_world* world, scree_joint_event* events, size_t size, int capacity,
                                              int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_joint_events";
	JointEvent* rows = NULL;
	TRY(world_check(world, function));
	TRY(check_list(function, "events", events, capacity, count));
	TRY(joint_events_find(world, function, &rows, count));
	for (int k = 0; k < *count && k < capacity; ++k)
	{
		scree_joint_event event = joint_event_result(world, rows + k);
		write_result((char*)events + size * (size_t)k, size, &event, sizeof event);
	}
	return SCREE_OK;
}
