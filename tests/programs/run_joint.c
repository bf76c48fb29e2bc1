// SPDX-License-Identifier: MIT
// run_joint.c -- the calls of joints, and what can be read of them.
#include "programs/run_call.h"
#include <float.h>
#include <stddef.h>
#include <string.h>

static scree_joint joint_of(const Turn* t, int k)
{
	return k >= 0 && k < MOST_NAMES ? t->names->joints[k] : SCREE_NULL_JOINT;
}

// -1 stands for a threshold that nothing exceeds.
static float threshold_of(const Turn* t, const char* name)
{
	float x = call_real(t, name);
	return x == -1.0f ? FLT_MAX : x;
}

// Keeps the handles of a batch that was made.
static scree_status make(const Turn* t, const scree_joint_def* defs, int count)
{
	scree_joint made[MOST_BATCH];
	int first = call_whole(t, "joint");
	scree_status status = scree_joints_create(t->world, defs, count, made);
	if (status == SCREE_OK && first >= 0 && first + count <= MOST_NAMES)
		memcpy(t->names->joints + first, made, (size_t)count * sizeof *made);
	return status;
}

static scree_pose second_pose(const Turn* t)
{
	return (scree_pose){call_vec(t, "bx", "by"), scree_rot_make(call_real(t, "bangle"))};
}

// Sides of a gear or a pulley, both with the same base.
static void set_sides(const Turn* t, scree_joint_def* def)
{
	static const char* const names[] = {"measure_a", "measure_b"};
	def->ratio = call_real(t, "gear");
	for (int k = 0; k < 2; ++k)
	{
		int measure = call_whole(t, names[k]);
		if (measure >= 0)
			def->sides[k].measure = (scree_measure)measure;
		def->sides[k].base = second_pose(t);
		def->sides[k].initial_angle = call_real(t, "near");
	}
}

static scree_status run_one(const Turn* t)
{
	scree_joint_def def = scree_joint_def_make((scree_joint_type)call_whole(t, "type"));
	int a = call_whole(t, "a"), b = call_whole(t, "b");
	def.body_a = a < 0 ? SCREE_NULL_BODY : call_body(t, a);
	def.body_b = b < 0 ? SCREE_NULL_BODY : call_body(t, b);
	def.hertz = call_real(t, "hertz");
	def.damping_ratio = call_real(t, "ratio");
	def.collide_connected = call_whole(t, "collides") != 0;
	def.can_break = call_whole(t, "breaks") != 0;
	def.force_threshold = threshold_of(t, "force");
	def.torque_threshold = threshold_of(t, "torque");
	def.frame_a = call_pose(t);
	def.path = call_path(t);
	def.initial_along = call_real(t, "near");
	if (call_whole(t, "far") == 0)
	{
		scree_status status = scree_joint_def_place(t->world, &def, call_pose(t));
		if (status != SCREE_OK)
			return status;
	}
	set_sides(t, &def);
	if (call_whole(t, "couple") != 0)
	{
		scree_status status = scree_joint_def_couple(t->world, &def);
		if (status != SCREE_OK)
			return status;
	}
	if (call_whole(t, "mount") != 0)
	{
		scree_status status = scree_joint_def_mount(t->world, &def, call_real(t, "near"));
		if (status != SCREE_OK)
			return status;
	}
	return make(t, &def, 1);
}

// Between neighbors of a row of bodies, or of each with the first, halfway.
static scree_status run_row(const Turn* t)
{
	scree_joint_def defs[MOST_BATCH];
	int count = call_batch(t, "joint"), first = call_whole(t, "body"), hub = call_whole(t, "hub");
	scree_vec apart = call_vec(t, "dx", "dy");
	for (int k = 0; k < count; ++k)
	{
		float part = hub ? (float)(k + 1) : 0.5f;
		defs[k] = scree_joint_def_make((scree_joint_type)call_whole(t, "type"));
		defs[k].body_a = call_body(t, hub ? first : first + k);
		defs[k].body_b = call_body(t, first + k + 1);
		defs[k].frame_a.position = (scree_vec){part * apart.x, part * apart.y};
		if (!hub)
			defs[k].frame_b.position = (scree_vec){-0.5f * apart.x, -0.5f * apart.y};
	}
	return make(t, defs, count);
}

static scree_joint_coordinate coordinate_of(const Turn* t)
{
	int has_drives = call_whole(t, "drives");
	return (scree_joint_coordinate){.target = call_real(t, "target"),
	                                .locked = has_drives & 1,
	                                .limited = has_drives & 2,
	                                .spring = has_drives & 4,
	                                .motor = has_drives & 8,
	                                .lock_hertz = call_real(t, "lock_hertz"),
	                                .lock_damping_ratio = call_real(t, "lock_ratio"),
	                                .lower = call_real(t, "lower"),
	                                .upper = call_real(t, "upper"),
	                                .spring_hertz = call_real(t, "spring_hertz"),
	                                .spring_damping_ratio = call_real(t, "spring_ratio"),
	                                .spring_max = call_real(t, "spring_max"),
	                                .spring_push = call_real(t, "push"),
	                                .spring_pull = call_real(t, "pull"),
	                                .motor_speed = call_real(t, "speed"),
	                                .motor_max = call_real(t, "motor_max")};
}

// The same value for one joint, or for each of a batch.
static scree_status run_change(const Turn* t)
{
	CallKind kind = t->call->kind;
	int first = call_whole(t, "joint"), count = call_batch(t, "joint");
	scree_coordinate which = kind == CALL_joint_enabled ? SCREE_ALONG : (scree_coordinate)call_whole(t, "which");
	scree_joint_coordinate coordinates[MOST_BATCH];
	scree_joint joints[MOST_BATCH];
	float values[MOST_BATCH];
	bool enabled[MOST_BATCH];
	bool alone = call_whole(t, "count") == 0;
	for (int k = 0; k < (alone ? 1 : count); ++k)
	{
		joints[k] = joint_of(t, first + k);
		if (kind == CALL_joint_coordinate)
			coordinates[k] = coordinate_of(t);
		else if (kind == CALL_joint_enabled)
			enabled[k] = call_whole(t, "enabled") != (k & 1); // neighbors by turns
		else
			values[k] = call_real(t, "x");
	}
	if (kind == CALL_joint_coordinate)
		return alone ? scree_joint_set_coordinate(t->world, joints[0], which, coordinates)
		             : scree_joints_set_coordinates(t->world, joints, which, coordinates, count);
	if (kind == CALL_joint_enabled)
		return alone ? scree_joint_set_enabled(t->world, joints[0], enabled[0])
		             : scree_joints_set_enabled(t->world, joints, enabled, count);
	if (kind == CALL_joint_target)
		return alone ? scree_joint_set_target(t->world, joints[0], which, values[0])
		             : scree_joints_set_targets(t->world, joints, which, values, count);
	return alone ? scree_joint_set_motor_speed(t->world, joints[0], which, values[0])
	             : scree_joints_set_motor_speeds(t->world, joints, which, values, count);
}

scree_status run_joint(const Turn* t)
{
	int first = call_whole(t, "joint"), count;
	scree_joint joint = joint_of(t, first);
	switch (t->call->kind)
	{
	case CALL_joint:
		return run_one(t);
	case CALL_joints:
		return run_row(t);
	case CALL_joint_destroy:
		count = call_batch(t, "joint");
		return call_whole(t, "count") == 0
		           ? scree_joint_destroy(t->world, joint)
		           : scree_joints_destroy(t->world, t->names->joints + (count > 0 ? first : 0), count);
	case CALL_joint_frames:
		return scree_joint_set_frames(t->world, joint, call_pose(t), second_pose(t));
	case CALL_joint_ratio:
		return scree_joint_set_ratio(t->world, joint, call_real(t, "gear"));
	case CALL_joint_bases:
		return scree_joint_set_bases(t->world, joint, call_pose(t), second_pose(t));
	case CALL_joint_stiffness:
		return scree_joint_set_stiffness(t->world, joint, call_real(t, "hertz"), call_real(t, "ratio"));
	case CALL_joint_thresholds:
		return scree_joint_set_thresholds(t->world, joint, threshold_of(t, "force"), threshold_of(t, "torque"),
		                                  call_whole(t, "breaks") != 0);
	case CALL_joint_elliptic:
		return scree_joint_set_elliptic(t->world, joint, call_whole(t, "elliptic") != 0);
	case CALL_collide_connected:
		return scree_joint_set_collide_connected(t->world, joint, call_whole(t, "collides") != 0);
	default:
		return run_change(t);
	}
}

// A NaN would be a difference between devices, and no answer.
static bool state_counts(const scree_joint_state* s)
{
	bool counts = s->force.x == s->force.x && s->force.y == s->force.y && s->torque == s->torque;
	for (int k = 0; k < 3; ++k)
		counts = counts && s->values[k] == s->values[k] && s->speeds[k] == s->speeds[k];
	return counts;
}

scree_status read_joints(const Turn* t, uint64_t* word)
{
	static scree_joint joints[MOST_NAMES];
	static scree_joint_state states[MOST_NAMES];
	static scree_joint_event events[MOST_NAMES];
	int counts[3] = {0};
	scree_status status = scree_world_get_joints(t->world, joints, MOST_NAMES, &counts[0]);
	int count = counts[0] < MOST_NAMES ? counts[0] : MOST_NAMES;
	if (status == SCREE_OK)
		status = scree_joints_get_states(t->world, joints, states, count);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		if (!state_counts(&states[k]))
			return SCREE_ERROR_DEVICE_FAILED;
		*word = read_mixed(*word, &joints[k], sizeof joints[k]);
		*word = read_mixed(*word, &states[k], offsetof(scree_joint_state, broken));
		*word = read_mixed(*word, &states[k].broken, sizeof states[k].broken);
	}
	if (status == SCREE_OK)
		status = scree_world_get_joint_events(t->world, events, MOST_NAMES, &counts[1]);
	for (int k = 0; k < counts[1] && k < MOST_NAMES && status == SCREE_OK; ++k)
	{
		float loads[] = {events[k].force, events[k].torque, events[k].broken ? 1.0f : 0.0f};
		*word = read_mixed(read_mixed(*word, loads, sizeof loads), &events[k].joint, sizeof events[k].joint);
	}
	scree_body body = call_body(t, call_whole(t, "body"));
	if (status == SCREE_OK && scree_body_is_valid(t->world, body))
		status = scree_body_get_joints(t->world, body, joints, 8, &counts[2]);
	*word = read_mixed(*word, counts, sizeof counts);
	return status;
}
