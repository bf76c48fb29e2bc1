// SPDX-License-Identifier: MIT
// run_joint.c -- makes the calls of joints, and reads the state of joints.
#include "programs/run_call.h"
#include <float.h>
#include <stddef.h>
#include <string.h>

static scree_joint joint_of(const CallRun* r, int k)
{
	return k >= 0 && k < MOST_NAMES ? r->names->joints[k] : SCREE_NULL_JOINT;
}

// Returns a threshold. The argument -1 stands for a threshold that is never exceeded.
static float threshold_of(const CallRun* r, const char* name)
{
	float x = call_real(r, name);
	return x == -1.0f ? FLT_MAX : x;
}

// Creates a batch of joints and keeps their handles.
static scree_status make(const CallRun* r, const scree_joint_def* defs, int count)
{
	scree_joint made[MOST_BATCH];
	int first = call_whole(r, "joint");
	scree_status status = scree_joints_create(r->world, defs, count, made);
	if (status == SCREE_OK && first >= 0 && first + count <= MOST_NAMES)
		memcpy(r->names->joints + first, made, (size_t)count * sizeof *made);
	return status;
}

static scree_pose second_pose(const CallRun* r)
{
	return (scree_pose){call_vec(r, "bx", "by"), scree_rot_make(call_real(r, "bangle"))};
}

// Sets the sides of a gear or a pulley; both sides get the same base.
static void set_sides(const CallRun* r, scree_joint_def* def)
{
	static const char* const names[] = {"measure_a", "measure_b"};
	def->ratio = call_real(r, "gear");
	for (int k = 0; k < 2; ++k)
	{
		int measure = call_whole(r, names[k]);
		if (measure >= 0)
			def->sides[k].measure = (scree_measure)measure;
		def->sides[k].base = second_pose(r);
		def->sides[k].initial_angle = call_real(r, "near");
	}
}

static scree_status run_one(const CallRun* r)
{
	scree_joint_def def = scree_joint_def_make((scree_joint_type)call_whole(r, "type"));
	int a = call_whole(r, "a"), b = call_whole(r, "b");
	def.body_a = a < 0 ? SCREE_NULL_BODY : call_body(r, a);
	def.body_b = b < 0 ? SCREE_NULL_BODY : call_body(r, b);
	def.hertz = call_real(r, "hertz");
	def.damping_ratio = call_real(r, "ratio");
	def.collide_connected = call_whole(r, "collides") != 0;
	def.can_break = call_whole(r, "breaks") != 0;
	def.force_threshold = threshold_of(r, "force");
	def.torque_threshold = threshold_of(r, "torque");
	def.frame_a = call_pose(r);
	def.path = call_path(r);
	def.initial_along = call_real(r, "near");
	if (call_whole(r, "far") == 0)
	{
		scree_status status = scree_joint_def_place(r->world, &def, call_pose(r));
		if (status != SCREE_OK)
			return status;
	}
	set_sides(r, &def);
	if (call_whole(r, "couple") != 0)
	{
		scree_status status = scree_joint_def_couple(r->world, &def);
		if (status != SCREE_OK)
			return status;
	}
	if (call_whole(r, "mount") != 0)
	{
		scree_status status = scree_joint_def_mount(r->world, &def, call_real(r, "near"));
		if (status != SCREE_OK)
			return status;
	}
	return make(r, &def, 1);
}

// Joins neighbors in a row of bodies, halfway between them; or joins the first body of the row with each of the others.
static scree_status run_row(const CallRun* r)
{
	scree_joint_def defs[MOST_BATCH];
	int count = call_batch(r, "joint"), first = call_whole(r, "body"), hub = call_whole(r, "hub");
	scree_vec apart = call_vec(r, "dx", "dy");
	for (int k = 0; k < count; ++k)
	{
		float part = hub ? (float)(k + 1) : 0.5f;
		defs[k] = scree_joint_def_make((scree_joint_type)call_whole(r, "type"));
		defs[k].body_a = call_body(r, hub ? first : first + k);
		defs[k].body_b = call_body(r, first + k + 1);
		defs[k].frame_a.position = (scree_vec){part * apart.x, part * apart.y};
		if (!hub)
			defs[k].frame_b.position = (scree_vec){-0.5f * apart.x, -0.5f * apart.y};
	}
	return make(r, defs, count);
}

static scree_joint_coordinate coordinate_of(const CallRun* r)
{
	int drives = call_whole(r, "drives");
	return (scree_joint_coordinate){.target = call_real(r, "target"),
	                                .locked = drives & 1,
	                                .limited = drives & 2,
	                                .spring = drives & 4,
	                                .motor = drives & 8,
	                                .lock_hertz = call_real(r, "lock_hertz"),
	                                .lock_damping_ratio = call_real(r, "lock_ratio"),
	                                .lower = call_real(r, "lower"),
	                                .upper = call_real(r, "upper"),
	                                .spring_hertz = call_real(r, "spring_hertz"),
	                                .spring_damping_ratio = call_real(r, "spring_ratio"),
	                                .spring_max = call_real(r, "spring_max"),
	                                .spring_push = call_real(r, "push"),
	                                .spring_pull = call_real(r, "pull"),
	                                .motor_speed = call_real(r, "speed"),
	                                .motor_max = call_real(r, "motor_max")};
}

// Changes one joint, or sets the same values for all joints of a batch.
static scree_status run_change(const CallRun* r)
{
	CallKind kind = r->call->kind;
	int first = call_whole(r, "joint"), count = call_batch(r, "joint");
	scree_coordinate which = kind == CALL_joint_enabled ? SCREE_ALONG : (scree_coordinate)call_whole(r, "which");
	scree_joint_coordinate coordinates[MOST_BATCH];
	scree_joint joints[MOST_BATCH];
	float values[MOST_BATCH];
	bool enabled[MOST_BATCH];
	bool alone = call_whole(r, "count") == 0;
	for (int k = 0; k < (alone ? 1 : count); ++k)
	{
		joints[k] = joint_of(r, first + k);
		if (kind == CALL_joint_coordinate)
			coordinates[k] = coordinate_of(r);
		else if (kind == CALL_joint_enabled)
			enabled[k] = call_whole(r, "enabled") != (k & 1); // disables every second joint of a batch
		else
			values[k] = call_real(r, "x");
	}
	if (kind == CALL_joint_coordinate)
		return alone ? scree_joint_set_coordinate(r->world, joints[0], which, coordinates)
		             : scree_joints_set_coordinates(r->world, joints, which, coordinates, count);
	if (kind == CALL_joint_enabled)
		return alone ? scree_joint_set_enabled(r->world, joints[0], enabled[0])
		             : scree_joints_set_enabled(r->world, joints, enabled, count);
	if (kind == CALL_joint_target)
		return alone ? scree_joint_set_target(r->world, joints[0], which, values[0])
		             : scree_joints_set_targets(r->world, joints, which, values, count);
	return alone ? scree_joint_set_motor_speed(r->world, joints[0], which, values[0])
	             : scree_joints_set_motor_speeds(r->world, joints, which, values, count);
}

scree_status run_joint(const CallRun* r)
{
	int first = call_whole(r, "joint"), count;
	scree_joint joint = joint_of(r, first);
	switch (r->call->kind)
	{
	case CALL_joint:
		return run_one(r);
	case CALL_joints:
		return run_row(r);
	case CALL_joint_destroy:
		count = call_batch(r, "joint");
		return call_whole(r, "count") == 0
		           ? scree_joint_destroy(r->world, joint)
		           : scree_joints_destroy(r->world, r->names->joints + (count > 0 ? first : 0), count);
	case CALL_joint_frames:
		return scree_joint_set_frames(r->world, joint, call_pose(r), second_pose(r));
	case CALL_joint_ratio:
		return scree_joint_set_ratio(r->world, joint, call_real(r, "gear"));
	case CALL_joint_bases:
		return scree_joint_set_bases(r->world, joint, call_pose(r), second_pose(r));
	case CALL_joint_stiffness:
		return scree_joint_set_stiffness(r->world, joint, call_real(r, "hertz"), call_real(r, "ratio"));
	case CALL_joint_thresholds:
		return scree_joint_set_thresholds(r->world, joint, threshold_of(r, "force"), threshold_of(r, "torque"),
		                                  call_whole(r, "breaks") != 0);
	case CALL_joint_elliptic:
		return scree_joint_set_elliptic(r->world, joint, call_whole(r, "elliptic") != 0);
	case CALL_collide_connected:
		return scree_joint_set_collide_connected(r->world, joint, call_whole(r, "collides") != 0);
	default:
		return run_change(r);
	}
}

// Returns whether a state has no NaN. States with NaN are not compared, because NaN may differ between devices.
static bool state_counts(const scree_joint_state* s)
{
	bool counts = s->force.x == s->force.x && s->force.y == s->force.y && s->torque == s->torque;
	for (int k = 0; k < 3; ++k)
		counts = counts && s->values[k] == s->values[k] && s->speeds[k] == s->speeds[k];
	return counts;
}

scree_status read_joints(const CallRun* r, uint64_t* word)
{
	static scree_joint joints[MOST_NAMES];
	static scree_joint_state states[MOST_NAMES];
	static scree_joint_event events[MOST_NAMES];
	int counts[3] = {0};
	scree_status status = scree_world_get_joints(r->world, joints, MOST_NAMES, &counts[0]);
	int count = counts[0] < MOST_NAMES ? counts[0] : MOST_NAMES;
	if (status == SCREE_OK)
		status = scree_joints_get_states(r->world, joints, states, count);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		if (!state_counts(&states[k]))
			return SCREE_ERROR_DEVICE_FAILED;
		*word = hash_words(*word, &joints[k], sizeof joints[k]);
		*word = hash_words(*word, &states[k], offsetof(scree_joint_state, broken));
		*word = hash_bytes(*word, &states[k].broken, sizeof states[k].broken);
	}
	if (status == SCREE_OK)
		status = scree_world_get_joint_events(r->world, events, MOST_NAMES, &counts[1]);
	for (int k = 0; k < counts[1] && k < MOST_NAMES && status == SCREE_OK; ++k)
	{
		float loads[] = {events[k].force, events[k].torque, events[k].broken ? 1.0f : 0.0f};
		*word = hash_words(hash_words(*word, loads, sizeof loads), &events[k].joint, sizeof events[k].joint);
	}
	scree_body body = call_body(r, call_whole(r, "body"));
	if (status == SCREE_OK && scree_body_is_valid(r->world, body))
		status = scree_body_get_joints(r->world, body, joints, 8, &counts[2]);
	*word = hash_words(*word, counts, sizeof counts);
	return status;
}
