// SPDX-License-Identifier: MIT
// joint_def.c -- makes definitions of joints: presets of each type, and frames computed from the poses of bodies.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/joint_check.h"
#include "world/objects/joints.h"
#include "world/objects/paths.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include <math.h>
#include <stddef.h>

static const struct // values that scree_joint_def_make presets for a type
{
	const char* name;
	unsigned locks; // locked coordinates, one bit each
} presets[JOINT_TYPES] = {
#define X(NAME, name, locks) [SCREE_JOINT_##NAME] = {name, locks},
#include "world/objects/joint_presets.def"
};

const char* scree_joint_type_name(scree_joint_type type)
{
	return (unsigned)type < JOINT_TYPES ? presets[type].name : "unknown";
}

// Size of a definition, in bytes, in the version that added gears and pulleys.
#define COUPLED_SIZE (offsetof(scree_joint_def, sides) + sizeof((scree_joint_def*)0)->sides)

static void set_spring(scree_joint_coordinate* coordinate, float hertz, float damping_ratio)
{
	coordinate->spring = true;
	coordinate->spring_hertz = hertz;
	coordinate->spring_damping_ratio = damping_ratio;
}

void scree_joint_def_make_sized(scree_joint_type type, scree_joint_def* def, size_t size)
{
	scree_joint_def made = {.size = (uint32_t)size,
	                        .type = type,
	                        .frame_a.rotation.c = 1.0f,
	                        .frame_b.rotation.c = 1.0f,
	                        .hertz = 60.0f,
	                        .damping_ratio = 2.0f,
	                        .force_threshold = FLT_MAX,
	                        .torque_threshold = FLT_MAX,
	                        .ratio = 1.0f,
	                        .collide_connected = type == SCREE_JOINT_PULLEY,
	                        .elliptic = type == SCREE_JOINT_MOTOR || type == SCREE_JOINT_TARGET};
	for (int side = 0; side < 2; ++side)
	{
		made.sides[side].base.rotation.c = 1.0f;
		made.sides[side].measure = type == SCREE_JOINT_PULLEY ? SCREE_MEASURE_DISTANCE : SCREE_MEASURE_ANGLE;
	}
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		made.coordinates[k].spring_max = made.coordinates[k].spring_push = made.coordinates[k].spring_pull = FLT_MAX;
		made.coordinates[k].locked = (unsigned)type < JOINT_TYPES && presets[type].locks >> k & 1;
		made.coordinates[k].motor = type == SCREE_JOINT_MOTOR;
	}
	if (type == SCREE_JOINT_DISTANCE)
		made.coordinates[SCREE_ALONG].target = 1.0f;
	if (type == SCREE_JOINT_WHEEL)
		set_spring(made.coordinates + SCREE_ALONG, 1.0f, 0.7f);
	for (int k = SCREE_ALONG; type == SCREE_JOINT_TARGET && k <= SCREE_ACROSS; ++k)
		set_spring(made.coordinates + k, 5.0f, 1.0f);
	write_result(def, size, &made, sizeof made);
}

// Converts a pose in the world to a frame of a body. If the body is null, the frame is the pose in the world.
static scree_status place(scree_world* world, ArgumentPlace at, const char* member, scree_body body, scree_pose pose,
                          scree_pose* frame)
{
	int index = 0;
	scree_pose own;
	*frame = pose;
	if (scree_body_is_null(body))
		return SCREE_OK;
	TRY(check_body(world, at, member, body, &index));
	TRY(api_body_get_pose(world, body, &own));
	scree_rot back = {own.rotation.c, -own.rotation.s};
	scree_vec shift = {pose.position.x - own.position.x, pose.position.y - own.position.y};
	frame->position = rot_vec(back, shift);
	frame->rotation = rot_product(back, pose.rotation);
	return SCREE_OK;
}

scree_status api_joint_def_place(scree_world* world, scree_joint_def* def, scree_pose pose)
{
	FLOAT_MODE_HERE;
	ArgumentPlace at = {"scree_joint_def_place", "def", ALONE};
	TRY(world_check(world, at.function));
	TRY(check_pointer(at.function, "def", def));
	TRY(check_definition(at, def, 0, &joint_definition));
	TRY(check_pose((ArgumentPlace){at.function, "pose", ALONE}, "", &pose));
	scree_pose frame_a, frame_b;
	TRY(place(world, at, ".body_a", def->body_a, pose, &frame_a));
	TRY(place(world, at, ".body_b", def->body_b, pose, &frame_b));
	if (def->type != SCREE_JOINT_PATH) // a path joint keeps frame A, which places the path
		def->frame_a = frame_a;
	def->frame_b = frame_b;
	return SCREE_OK;
}

scree_status api_joint_def_mount(scree_world* world, scree_joint_def* def, float along)
{
	FLOAT_MODE_HERE;
	ArgumentPlace at = {"scree_joint_def_mount", "def", ALONE};
	int path = 0, body;
	TRY(world_check(world, at.function));
	TRY(check_pointer(at.function, "def", def));
	TRY(check_definition(at, def, 0, &joint_definition));
	if (def->size < joint_definition.bytes)
		return refuse(SCREE_ERROR_INVALID, at, ".size", "is %u, of a version without paths", def->size);
	if (def->type != SCREE_JOINT_PATH)
		return refuse(SCREE_ERROR_INVALID, at, ".type", "is %s: only a path can be mounted",
		              scree_joint_type_name(def->type));
	TRY(check_path(world, at, ".path", def->path, &path));
	TRY(check_real((ArgumentPlace){at.function, "along", ALONE}, "", along, -SCREE_MAX_COORDINATE,
	               SCREE_MAX_COORDINATE));
	scree_pose frame = def->frame_a, own = {{0.0f, 0.0f}, {1.0f, 0.0f}};
	TRY(check_pose(at, ".frame_a", &frame));
	if (!scree_body_is_null(def->body_a))
	{
		TRY(check_body(world, at, ".body_a", def->body_a, &body));
		TRY(api_body_get_pose(world, def->body_a, &own));
	}
	scree_pose pose = pose_product(pose_product(own, frame), path_pose_at(world, path, along));
	TRY(place(world, at, ".body_b", def->body_b, pose, &def->frame_b));
	def->initial_along = along;
	return SCREE_OK;
}

static scree_status measure(scree_world* world, ArgumentPlace at, const scree_joint_def* def, int k, float* value)
{
	static const char* const members[] = {".body_a", ".body_b"};
	const scree_joint_side* side = def->sides + k;
	scree_body body = k ? def->body_b : def->body_a;
	scree_pose pose = {{0.0f, 0.0f}, {1.0f, 0.0f}}, frame = k ? def->frame_b : def->frame_a, base = side->base;
	int index;
	if (!scree_body_is_null(body))
	{
		TRY(check_body(world, at, members[k], body, &index));
		TRY(api_body_get_pose(world, body, &pose));
	}
	scree_vec anchor = pose_point(pose, frame.position);
	scree_vec d = {anchor.x - base.position.x, anchor.y - base.position.y};
	if (side->measure == SCREE_MEASURE_TRANSLATION)
		*value = d.x * base.rotation.c + d.y * base.rotation.s;
	else if (side->measure == SCREE_MEASURE_DISTANCE)
		*value = sqrtf(d.x * d.x + d.y * d.y);
	else
	{
		scree_rot now = rot_product(pose.rotation, frame.rotation);
		*value = scree_rot_get_angle(rot_product((scree_rot){base.rotation.c, -base.rotation.s}, now));
	}
	return SCREE_OK;
}

scree_status api_joint_def_couple(scree_world* world, scree_joint_def* def)
{
	FLOAT_MODE_HERE;
	ArgumentPlace at = {"scree_joint_def_couple", "def", ALONE};
	float values[2];
	TRY(world_check(world, at.function));
	TRY(check_pointer(at.function, "def", def));
	TRY(check_definition(at, def, 0, &joint_definition));
	if (def->size < COUPLED_SIZE)
		return refuse(SCREE_ERROR_INVALID, at, ".size", "is %u, of a version without gears and pulleys", def->size);
	if (!joint_couples(def->type))
		return refuse(SCREE_ERROR_INVALID, at, ".type", "is %s: only a gear or a pulley couples",
		              scree_joint_type_name(def->type));
	uint32_t size = def->size;
	scree_joint_def local, made = *(const scree_joint_def*)definition_at(def, 0, &joint_definition, &local);
	TRY(check_joint_coupling(at, &made));
	TRY(check_pose(at, ".frame_a", &made.frame_a));
	TRY(check_pose(at, ".frame_b", &made.frame_b));
	for (int k = 0; k < 2; ++k)
		TRY(measure(world, at, &made, k, values + k));
	for (int k = 0; k < 2; ++k)
		made.sides[k].initial_angle = made.sides[k].measure == SCREE_MEASURE_ANGLE ? values[k] : 0.0f;
	made.coordinates[SCREE_ALONG].target = values[1] + made.ratio * values[0];
	TRY(check_coordinate(at, made.type, SCREE_ALONG, &made.coordinates[SCREE_ALONG]));
	made.size = size;
	write_result(def, size, &made, sizeof made);
	return SCREE_OK;
}
