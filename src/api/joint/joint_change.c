// SPDX-License-Identifier: MIT
// joint_change.c -- changes coordinates and frames of joints, and enables joints, one joint or a batch at a time.
#include "platform/processor.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/joint_check.h"
#include "world/objects/joints.h"
#include "world/record/api_calls.h"
#include "world/structure.h"
#include "world/upload/upload.h"
#include <stddef.h>
#include <string.h>

typedef struct // a change of one coordinate, of the frames, or of enabling, for a batch of joints
{
	scree_world* world;
	ArgumentPlace joint, value;
	const scree_joint* joints;
	int count;
	scree_coordinate which;
	size_t member; // bytes: offset of the changed number in scree_joint_coordinate
	bool moves;    // true: the frames change
} Change;

typedef scree_status (*Setter)(const Change* change, ArgumentPlace at, const void* values, int k, scree_joint_def* def);

// Uploads the edits if one of the joints will get its number of whole turns: a later change of its target or limits must
// not change that number, as it does not if the user reads something in between.
static scree_status upload_turns(const Change* change)
{
	bool counts = false;
	for (int k = 0; k < change->count; ++k)
		counts |= change->world->host_joints[change->joints[k].index - 1].counts;
	return counts ? world_upload(change->world) : SCREE_OK;
}

static bool has_turns(const JointEdit* edit) { return ((int)edit->data.modes & JOINT_COUNTED(JOINT_ANGLE)) != 0; }

static scree_status change_all(const Change* change, const void* values, Setter set)
{
	scree_world* world = change->world;
	ArgumentPlace at = change->joint, value = change->value;
	TRY(world_check(world, at.function));
	TRY(check_batch(at.function, at.argument, change->joints, change->count));
	TRY(check_batch(at.function, value.argument, values, change->count));
	TRY(check_which((ArgumentPlace){at.function, "which", ALONE}, change->which));
	for (int k = 0, index = 0; k < change->count; ++k)
	{
		if (at.index != ALONE)
			at.index = value.index = k;
		TRY(check_joint(world, at, change->joints[k], &index));
		scree_joint_def def = world->host_joints[index].def;
		TRY(set(change, value, values, k, &def));
	}
	TRY(upload_turns(change));
	TRY(edits_reserve(world, at.function, 0, 0, (JOINT_COMMANDS + (change->moves ? 2 : 0)) * change->count));
	for (int k = 0; k < change->count; ++k)
	{
		int index = (int)change->joints[k].index - 1;
		scree_joint_def* def = &world->host_joints[index].def;
		const scree_joint_def old = *def;
		const JointEdit before = joint_edit(world, index);
		set(change, value, values, k, def);
		const JointEdit after = joint_edit(world, index);
		bool same = before.flags == after.flags && memcmp(&before.data, &after.data, sizeof after.data) == 0;
		world->host_joints[index].seeks |= change->moves && !same;
		// a new joint begins with the number of its last target
		world->host_joints[index].counts |=
		    has_turns(&after) && !has_turns(&before) && !world->host_joints[index].created;
		world->chains_stale |= change->moves && !same; // branches depend on the arms of hubs
		if (change->moves)
			joint_anchors(world, index);
		// a value that is set again, for instance in each step, wakes nothing and is not uploaded; nor is one without effect
		if (!same)
			joint_changed(world, index, def->disabled != old.disabled);
		else if (memcmp(&old, def, sizeof old) != 0)
			structure_changed(world);
	}
	return SCREE_OK;
}

static Change batch(scree_world* world, const char* function, const char* value, const scree_joint* joints, int count,
                    scree_coordinate which)
{
	return (Change){world, {function, "joints", 0}, {function, value, 0}, joints, count, which, 0, false};
}

static Change single(scree_world* world, const char* function, const char* value, const scree_joint* joint,
                     scree_coordinate which)
{
	return (Change){world, {function, "joint", ALONE}, {function, value, ALONE}, joint, 1, which, 0, false};
}

static scree_status set_coordinate(const Change* change, ArgumentPlace at, const void* values, int k,
                                   scree_joint_def* def)
{
	const scree_joint_coordinate* value = (const scree_joint_coordinate*)values + k;
	TRY(check_coordinate(at, def->type, change->which, value));
	// chains contain only joints with locks, so a new or removed lock may change the chains
	change->world->chains_stale |= def->coordinates[change->which].locked != value->locked;
	def->coordinates[change->which] = *value;
	return SCREE_OK;
}

scree_status api_joints_set_coordinates(scree_world* world, const scree_joint* joints, scree_coordinate which,
                                        const scree_joint_coordinate* values, int count)
{
	FLOAT_MODE_HERE;
	Change change = batch(world, "scree_joints_set_coordinates", "values", joints, count, which);
	return change_all(&change, values, set_coordinate);
}

scree_status api_joint_set_coordinate(scree_world* world, scree_joint joint, scree_coordinate which,
                                      const scree_joint_coordinate* value)
{
	FLOAT_MODE_HERE;
	Change change = single(world, "scree_joint_set_coordinate", "value", &joint, which);
	return change_all(&change, value, set_coordinate);
}

scree_status api_joint_get_coordinate(const scree_world* world, scree_joint joint, scree_coordinate which,
                                      scree_joint_coordinate* value)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joint_get_coordinate";
	int index = 0;
	TRY(check_pointer(function, "world", world));
	TRY(check_joint(world, (ArgumentPlace){function, "joint", ALONE}, joint, &index));
	TRY(check_which((ArgumentPlace){function, "which", ALONE}, which));
	TRY(check_pointer(function, "value", value));
	*value = world->host_joints[index].def.coordinates[which];
	return SCREE_OK;
}

static scree_status set_number(const Change* change, ArgumentPlace at, const void* values, int k, scree_joint_def* def)
{
	float value = ((const float*)values)[k];
	memcpy((char*)(def->coordinates + change->which) + change->member, &value, sizeof value);
	return check_real(at, "", value, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE);
}

scree_status api_joints_set_targets(scree_world* world, const scree_joint* joints, scree_coordinate which,
                                    const float* targets, int count)
{
	FLOAT_MODE_HERE;
	Change change = batch(world, "scree_joints_set_targets", "targets", joints, count, which);
	change.member = offsetof(scree_joint_coordinate, target);
	return change_all(&change, targets, set_number);
}

scree_status api_joint_set_target(scree_world* world, scree_joint joint, scree_coordinate which, float target)
{
	FLOAT_MODE_HERE;
	Change change = single(world, "scree_joint_set_target", "target", &joint, which);
	change.member = offsetof(scree_joint_coordinate, target);
	return change_all(&change, &target, set_number);
}

scree_status api_joints_set_motor_speeds(scree_world* world, const scree_joint* joints, scree_coordinate which,
                                         const float* speeds, int count)
{
	FLOAT_MODE_HERE;
	Change change = batch(world, "scree_joints_set_motor_speeds", "speeds", joints, count, which);
	change.member = offsetof(scree_joint_coordinate, motor_speed);
	return change_all(&change, speeds, set_number);
}

scree_status api_joint_set_motor_speed(scree_world* world, scree_joint joint, scree_coordinate which, float speed)
{
	FLOAT_MODE_HERE;
	Change change = single(world, "scree_joint_set_motor_speed", "speed", &joint, which);
	change.member = offsetof(scree_joint_coordinate, motor_speed);
	return change_all(&change, &speed, set_number);
}

typedef struct
{
	const scree_pose *a, *b;
	const char *name_a, *name_b;
} Frames;

static scree_status set_frames(const Change* change, ArgumentPlace at, const void* values, int k, scree_joint_def* def)
{
	const Frames* frames = values;
	def->frame_a = frames->a[k];
	def->frame_b = frames->b[k];
	at.argument = frames->name_a;
	TRY(check_pose(at, "", &def->frame_a));
	at.argument = frames->name_b;
	(void)change;
	return check_pose(at, "", &def->frame_b);
}

scree_status api_joints_set_frames(scree_world* world, const scree_joint* joints, const scree_pose* frames_a,
                                   const scree_pose* frames_b, int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_joints_set_frames";
	Frames frames = {frames_a, frames_b, "frames_a", "frames_b"};
	Change change = batch(world, function, "frames_a", joints, count, SCREE_ALONG);
	change.moves = true;
	TRY(world_check(world, function));
	TRY(check_batch(function, "frames_a", frames_a, count));
	TRY(check_batch(function, "frames_b", frames_b, count));
	return change_all(&change, &frames, set_frames);
}

scree_status api_joint_set_frames(scree_world* world, scree_joint joint, scree_pose frame_a, scree_pose frame_b)
{
	FLOAT_MODE_HERE;
	Frames frames = {&frame_a, &frame_b, "frame_a", "frame_b"};
	Change change = single(world, "scree_joint_set_frames", "frame_a", &joint, SCREE_ALONG);
	change.moves = true;
	return change_all(&change, &frames, set_frames);
}

static scree_status set_enabled(const Change* change, ArgumentPlace at, const void* values, int k, scree_joint_def* def)
{
	def->disabled = !((const bool*)values)[k];
	(void)change;
	(void)at;
	return SCREE_OK;
}

scree_status api_joints_set_enabled(scree_world* world, const scree_joint* joints, const bool* enabled, int count)
{
	FLOAT_MODE_HERE;
	Change change = batch(world, "scree_joints_set_enabled", "enabled", joints, count, SCREE_ALONG);
	return change_all(&change, enabled, set_enabled);
}

scree_status api_joint_set_enabled(scree_world* world, scree_joint joint, bool enabled)
{
	FLOAT_MODE_HERE;
	Change change = single(world, "scree_joint_set_enabled", "enabled", &joint, SCREE_ALONG);
	return change_all(&change, &enabled, set_enabled);
}

bool scree_joint_is_enabled(const scree_world* world, scree_joint joint)
{
	return world && joint_is_valid(world, joint) && !world->host_joints[joint.index - 1].def.disabled;
}
