// SPDX-License-Identifier: MIT
// test_bad_joints.c -- checks that every function of joints refuses bad arguments with a message that names argument
// and value, and changes nothing.
#include "support/bad_input.h"
#include "support/make_joints.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static scree_joint joint, weld, gear, gone, alien;

static scree_joint_def good_def(void)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.body_a = body;
	def.body_b = second;
	return def;
}

static scree_joint_def good_gear(void)
{
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_GEAR);
	def.body_a = body;
	def.body_b = second;
	return def;
}

static int set_up(void** state)
{
	set_up_bad_input(state);
	scree_joint_def def = good_def();
	joint = add_joint(world, &def);
	gone = add_joint(world, &def);
	OK(scree_joint_destroy(world, gone));
	def.type = SCREE_JOINT_WELD;
	def.body_a = SCREE_NULL_BODY;
	weld = add_joint(world, &def);
	def = good_gear();
	gear = add_joint(world, &def);

	// a joint of another world, in a slot that does not exist in this world
	scree_body_def body_def = scree_body_def_default();
	scree_joint_def alien_def = scree_joint_def_make(SCREE_JOINT_WELD);
	alien_def.body_b = create_body(other, &body_def);
	for (int k = 0; k < 5; ++k)
		alien = add_joint(other, &alien_def);
	run_steps(world, 1);
	before = hash_of(world);
	return 0;
}

static void definitions(void** state)
{
	(void)state;
	scree_joint made[2];
	scree_joint_def defs[2] = {good_def(), good_def()};
	INVALID(scree_joints_create, (NULL, defs, 2, made), "world is null");
	INVALID(scree_joints_create, (world, NULL, 2, made), "defs is null");
	INVALID(scree_joints_create, (world, defs, -1, made), "count is -1");
	INVALID(scree_joint_create, (world, NULL, made), "def is null");
	INVALID(scree_joint_create, (NULL, defs, made), "world is null");
#define DEF(status, change, sentence)                                                 \
	defs[1] = good_def();                                                             \
	defs[1].change;                                                                   \
	REFUSED(scree_joints_create, (world, defs, 2, made), status, "defs[1]" sentence); \
	REFUSED(scree_joint_create, (world, &defs[1], made), status, "def" sentence)
	DEF(SCREE_ERROR_INVALID, size = 0, ".size is 0: the definition was not made by scree_joint_def_make");
	DEF(SCREE_ERROR_INVALID, type = (scree_joint_type)13, ".type is 13, not a scree_joint_type");
	DEF(SCREE_ERROR_INVALID, type = (scree_joint_type)-1, ".type is -1, not a scree_joint_type");
	DEF(SCREE_ERROR_STALE, body_a = stale, ".body_a (index 4");
	DEF(SCREE_ERROR_STALE, body_b = stale, ".body_b (index 4");
	DEF(SCREE_ERROR_INVALID, body_a = second, ".body_b is body_a too");
	DEF(SCREE_ERROR_INVALID, body_a = body; defs[1].body_b = body, ".body_b is body_a too");
	DEF(SCREE_ERROR_INVALID, body_a = SCREE_NULL_BODY; defs[1].body_b = SCREE_NULL_BODY, ".body_b");
	DEF(SCREE_ERROR_INVALID, frame_a.position.x = NAN, ".frame_a.position.x is nan");
	DEF(SCREE_ERROR_INVALID, frame_b.position.y = 2e5f, ".frame_b.position.y is 200000");
	DEF(SCREE_ERROR_INVALID, frame_b.rotation.c = 0, ".frame_b.rotation is (0, 0)");
	DEF(SCREE_ERROR_INVALID, hertz = -1, ".hertz is -1");
	DEF(SCREE_ERROR_INVALID, hertz = NAN, ".hertz is nan");
	DEF(SCREE_ERROR_INVALID, hertz = 2e6f, ".hertz is 2000000");
	DEF(SCREE_ERROR_INVALID, damping_ratio = -1, ".damping_ratio is -1");
	DEF(SCREE_ERROR_INVALID, damping_ratio = INFINITY, ".damping_ratio is inf");
	DEF(SCREE_ERROR_INVALID, force_threshold = -1, ".force_threshold is -1");
	DEF(SCREE_ERROR_INVALID, torque_threshold = NAN, ".torque_threshold is nan");
	DEF(SCREE_ERROR_INVALID, coordinates[0].target = NAN, ".coordinates[SCREE_ALONG].target is nan");
	DEF(SCREE_ERROR_INVALID, coordinates[1].lock_hertz = -1, ".coordinates[SCREE_ACROSS].lock_hertz is -1");
	DEF(SCREE_ERROR_INVALID, coordinates[2].spring_max = -1, ".coordinates[SCREE_ANGLE].spring_max is -1");
#undef DEF
	defs[0] = scree_joint_def_make((scree_joint_type)77);
	defs[0].body_b = second;
	INVALID(scree_joint_create, (world, defs, made), "def.type is 77");
	assert_string_equal(scree_joint_type_name((scree_joint_type)77), "unknown");
}

// Checks each number of a coordinate, in a definition and in the functions that set this number.
static void coordinates(void** state)
{
	(void)state;
	static const struct
	{
		const char* name;
		size_t offset;
		float low, high; // one value below the valid range, and one above it
	} numbers[] = {
#define NUMBER(name, low, high) {#name, offsetof(scree_joint_coordinate, name), low, high}
	    NUMBER(target, -2e5f, 2e5f),
	    NUMBER(lock_hertz, -1.0f, 2e6f),
	    NUMBER(lock_damping_ratio, -1.0f, 2e6f),
	    NUMBER(lower, -2e5f, 2e5f),
	    NUMBER(upper, -2e5f, 2e5f),
	    NUMBER(spring_hertz, -1.0f, 2e6f),
	    NUMBER(spring_damping_ratio, -1.0f, 2e6f),
	    NUMBER(spring_max, -1.0f, INFINITY),
	    NUMBER(spring_push, -1.0f, INFINITY),
	    NUMBER(spring_pull, -1.0f, INFINITY),
	    NUMBER(motor_speed, -2e5f, 2e5f),
	    NUMBER(motor_max, -1.0f, INFINITY),
	};
	for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k)
		for (int which = 0; which < 3; ++which)
			for (int variant = 0; variant < 3; ++variant)
			{
				scree_joint_def def = good_def();
				scree_joint handles[2] = {joint, weld};
				scree_joint_coordinate values[2] = {def.coordinates[which], def.coordinates[which]};
				float bad = variant == 0 ? numbers[k].low : variant == 1 ? numbers[k].high : NAN;
				memcpy((char*)&values[1] + numbers[k].offset, &bad, sizeof bad);
				def.coordinates[which] = values[1];
				INVALID(scree_joint_create, (world, &def, NULL), numbers[k].name);
				INVALID(scree_joint_set_coordinate, (world, joint, (scree_coordinate)which, &values[1]),
				        numbers[k].name);
				INVALID(scree_joints_set_coordinates, (world, handles, (scree_coordinate)which, values, 2),
				        numbers[k].name);
				INVALID(scree_joints_set_coordinates, (world, handles, (scree_coordinate)which, values, 2),
				        "values[1]");
			}
	scree_joint_coordinate crossed;
	OK(scree_joint_get_coordinate(world, joint, SCREE_ANGLE, &crossed));
	crossed.lower = 1.0f;
	crossed.limited = true;
	INVALID(scree_joint_set_coordinate, (world, joint, SCREE_ANGLE, &crossed), "lower is 1, above upper, which is 0");
	INVALID(scree_joint_set_coordinate, (world, joint, (scree_coordinate)3, &crossed), "which is 3");
	INVALID(scree_joint_set_coordinate, (world, joint, (scree_coordinate)-1, &crossed), "which is -1");
	INVALID(scree_joint_set_coordinate, (world, joint, SCREE_ANGLE, NULL), "value is null");
	INVALID(scree_joint_get_coordinate, (world, joint, SCREE_ANGLE, NULL), "value is null");
	INVALID(scree_joint_get_coordinate, (world, joint, (scree_coordinate)3, &crossed), "which is 3");
	STALE(scree_joint_get_coordinate, (world, gone, SCREE_ANGLE, &crossed), "joint (index 2");
}

static void places(void** state)
{
	(void)state;
	scree_joint_def def = good_def(), same = def;
	scree_pose bad = good_pose;
	INVALID(scree_joint_def_place, (NULL, &def, good_pose), "world is null");
	INVALID(scree_joint_def_place, (world, NULL, good_pose), "def is null");
	bad.position.x = NAN;
	INVALID(scree_joint_def_place, (world, &def, bad), "pose.position.x is nan");
	bad = good_pose;
	bad.rotation.s = 3.0f;
	INVALID(scree_joint_def_place, (world, &def, bad), "pose.rotation is (0, 3)");
	def.body_b = stale;
	STALE(scree_joint_def_place, (world, &def, good_pose), "def.body_b (index 4");
	def.body_b = second;
	def.size = 0;
	INVALID(scree_joint_def_place, (world, &def, good_pose), "def.size is 0");
	def.size = same.size;
	assert_memory_equal(&def, &same, sizeof def);
}

// Checks the members that only gears and pulleys have, in scree_joint_create and in scree_joint_def_couple.
static void couplings(void** state)
{
	(void)state;
	scree_joint_def defs[2], same;
	defs[0] = good_gear();
#define DEF(change, sentence)                                                     \
	for (int pulley = 0; pulley < 2; ++pulley)                                    \
	{                                                                             \
		defs[1] = good_gear();                                                    \
		defs[1].type = pulley ? SCREE_JOINT_PULLEY : SCREE_JOINT_GEAR;            \
		defs[1].change;                                                           \
		INVALID(scree_joints_create, (world, defs, 2, NULL), "defs[1]" sentence); \
		INVALID(scree_joint_create, (world, &defs[1], NULL), "def" sentence);     \
		same = defs[1];                                                           \
		INVALID(scree_joint_def_couple, (world, &defs[1]), "def" sentence);       \
		assert_memory_equal(&defs[1], &same, sizeof same);                        \
	}
	DEF(sides[0].measure = (scree_measure)3, ".sides[0].measure is 3, not a scree_measure");
	DEF(sides[1].measure = (scree_measure)-1, ".sides[1].measure is -1, not a scree_measure");
	DEF(sides[0].base.position.x = INFINITY, ".sides[0].base.position.x is inf");
	DEF(sides[1].base.position.y = NAN, ".sides[1].base.position.y is nan");
	DEF(sides[1].base.position.y = -2e5f, ".sides[1].base.position.y is -200000");
	DEF(sides[0].base.rotation.c = 0.0f, ".sides[0].base.rotation is (0, 0)");
	DEF(sides[1].base.rotation.s = NAN, ".sides[1].base.rotation is (1, nan)");
	DEF(sides[0].initial_angle = NAN, ".sides[0].initial_angle is nan");
	DEF(sides[1].initial_angle = 2e5f, ".sides[1].initial_angle is 200000");
	DEF(ratio = 2e6f, ".ratio is 2000000");
	DEF(ratio = -2e6f, ".ratio is -2000000");
	DEF(ratio = NAN, ".ratio is nan");
	DEF(frame_b.position.x = NAN, ".frame_b.position.x is nan");
#undef DEF
}

// A gear or a pulley has only the coordinate along. A lock, limit, spring or motor of another coordinate is refused.
static void held_coordinates(void** state)
{
	(void)state;
	static const char* const names[] = {"SCREE_ALONG", "SCREE_ACROSS", "SCREE_ANGLE"};
	for (int which = SCREE_ACROSS; which <= SCREE_ANGLE; ++which)
		for (int k = 0; k < 4; ++k)
		{
			scree_joint_def def = good_gear();
			scree_joint handles[2] = {joint, gear};
			scree_joint_coordinate values[2] = {def.coordinates[which], def.coordinates[which]};
			char sentence[96];
			bool* parts[] = {&values[1].locked, &values[1].limited, &values[1].spring, &values[1].motor};
			*parts[k] = true;
			def.coordinates[which] = values[1];
			snprintf(sentence, sizeof sentence, "def.coordinates[%s] is held: a gear has the coordinate along only",
			         names[which]);
			INVALID(scree_joint_create, (world, &def, NULL), sentence);
			def.type = SCREE_JOINT_PULLEY;
			INVALID(scree_joint_create, (world, &def, NULL), "is held: a pulley has the coordinate along only");
			snprintf(sentence, sizeof sentence, "coordinates[%s] is held: a gear has the coordinate along only",
			         names[which]);
			INVALID(scree_joint_set_coordinate, (world, gear, (scree_coordinate)which, &values[1]), sentence);
			INVALID(scree_joints_set_coordinates, (world, handles, (scree_coordinate)which, values, 2), "values[1]");
		}
}

// A definition with a motor on a locked coordinate is refused, unless the speed and the maximum of the motor are 0. In
// an existing joint, the motor of a locked coordinate may be set.
static void locked_motors(void** state)
{
	(void)state;
	stay_awake(world); // a new joint wakes its bodies, which is in the hash of a world that sleeps
	before = hash_of(world);
	for (int which = SCREE_ALONG; which <= SCREE_ANGLE; ++which)
	{
		static const char* const names[] = {"SCREE_ALONG", "SCREE_ACROSS", "SCREE_ANGLE"};
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_MOTOR);
		scree_joint_coordinate* c = def.coordinates + which;
		char sentence[96];
		def.body_a = body;
		def.body_b = second;
		c->locked = true;
		snprintf(sentence, sizeof sentence, "def.coordinates[%s].motor is true, and the coordinate is locked",
		         names[which]);
		c->motor_speed = -2.0f;
		INVALID(scree_joint_create, (world, &def, NULL), sentence);
		c->motor_speed = 0.0f;
		c->motor_max = 3.0f;
		INVALID(scree_joint_create, (world, &def, NULL), sentence);
		INVALID(scree_joints_create, (world, &def, 1, NULL), names[which]);
		c->motor_max = 0.0f;
		scree_joint made = add_joint(world, &def);
		c->motor_max = 3.0f;
		c->motor_speed = 1.0f;
		OK(scree_joint_set_coordinate(world, made, (scree_coordinate)which, c));
		OK(scree_joint_destroy(world, made));
	}
}

static void measures(void** state)
{
	(void)state;
	scree_joint_def def = good_gear(), same = def;
	INVALID(scree_joint_def_couple, (NULL, &def), "world is null");
	INVALID(scree_joint_def_couple, (world, NULL), "def is null");
#define DEF(change, undo, status, sentence)                           \
	def.change;                                                       \
	REFUSED(scree_joint_def_couple, (world, &def), status, sentence); \
	def.undo;                                                         \
	assert_memory_equal(&def, &same, sizeof def)
	DEF(type = SCREE_JOINT_REVOLUTE, type = same.type, SCREE_ERROR_INVALID,
	    "def.type is revolute: only a gear or a pulley couples");
	DEF(type = (scree_joint_type)77, type = same.type, SCREE_ERROR_INVALID, "def.type is unknown");
	DEF(size = 0, size = same.size, SCREE_ERROR_INVALID, "def.size is 0: the definition was not made by");
	DEF(body_a = stale, body_a = body, SCREE_ERROR_STALE, "def.body_a (index 4");
	DEF(body_b = stale, body_b = second, SCREE_ERROR_STALE, "def.body_b (index 4");

	// size of the definition in versions without gears and pulleys
	uint32_t older = (uint32_t)offsetof(scree_joint_def, ratio);
	char sentence[96];
	snprintf(sentence, sizeof sentence, "def.size is %u, of a version without gears and pulleys", older);
	DEF(size = older, size = same.size, SCREE_ERROR_INVALID, sentence);

#undef DEF

	// a definition that is refused, because its coordinate is 1,000 km, stays unchanged; so its bases, whose rotations
	// have a length slightly below 1, are not normalized
	for (int k = 0; k < 2; ++k)
	{
		def.sides[k].measure = SCREE_MEASURE_DISTANCE;
		def.sides[k].base = (scree_pose){{1000.0f, 0.0f}, {0.9999f, 0.0f}};
	}
	def.ratio = 1000.0f;
	same = def;
	INVALID(scree_joint_def_couple, (world, &def), "def.coordinates[SCREE_ALONG].target is ");
	assert_memory_equal(&def, &same, sizeof def);

	// members that an older definition does not have are read as 0, so the rotation of a base is (0, 0)
	def.size = older;
	INVALID(scree_joint_create, (world, &def, NULL), "def.sides[0].base.rotation is (0, 0)");
}

static void coupling_changes(void** state)
{
	(void)state;
	scree_pose bad = good_pose, flat = good_pose;
	bad.position.x = NAN;
	flat.rotation.s = 0.0f;
	INVALID(scree_joint_set_ratio, (NULL, gear, 1.0f), "world is null");
	INVALID(scree_joint_set_ratio, (world, joint, 1.0f), "joint is of type revolute, not a gear or a pulley");
	INVALID(scree_joint_set_ratio, (world, gear, NAN), "ratio is nan");
	INVALID(scree_joint_set_ratio, (world, gear, 2e6f), "ratio is 2000000");
	INVALID(scree_joint_set_ratio, (world, gear, -INFINITY), "ratio is -inf");
	STALE(scree_joint_set_ratio, (world, gone, 1.0f), "joint (index 2");
	STALE(scree_joint_set_ratio, (world, alien, 1.0f), "joint (index 5");
	STALE(scree_joint_set_ratio, (world, SCREE_NULL_JOINT, 1.0f), "joint is null");
	INVALID(scree_joint_set_bases, (NULL, gear, good_pose, good_pose), "world is null");
	INVALID(scree_joint_set_bases, (world, weld, good_pose, good_pose),
	        "joint is of type weld, not a gear or a pulley");
	INVALID(scree_joint_set_bases, (world, gear, bad, good_pose), "base_a.position.x is nan");
	INVALID(scree_joint_set_bases, (world, gear, good_pose, bad), "base_b.position.x is nan");
	INVALID(scree_joint_set_bases, (world, gear, good_pose, flat), "base_b.rotation is (0, 0)");
	STALE(scree_joint_set_bases, (world, gone, good_pose, good_pose), "joint (index 2");
	STALE(scree_joint_set_bases, (world, SCREE_NULL_JOINT, good_pose, good_pose), "joint is null");
	scree_joint_def def;
	OK(scree_joint_get_def(world, gear, &def));
	assert_true(def.ratio == 1.0f && def.sides[0].base.position.x == 0.0f && def.sides[1].base.rotation.c == 1.0f);
}

static void handles(void** state)
{
	(void)state;
	scree_joint twice[2] = {joint, joint}, listed[2];
	int count;
	STALE(scree_joints_destroy, (world, twice, 2), "joints[1] is twice in the batch");
	twice[1] = gone;
	STALE(scree_joints_destroy, (world, twice, 2), "joints[1] (index 2");
	INVALID(scree_joints_destroy, (world, NULL, 2), "joints is null");
	INVALID(scree_joints_destroy, (world, twice, -1), "count is -1");
	INVALID(scree_joint_destroy, (NULL, joint), "world is null");
	STALE(scree_joint_destroy, (world, gone), "joint (index 2");
	STALE(scree_joint_destroy, (world, SCREE_NULL_JOINT), "joint is null");
	STALE(scree_joint_destroy, (world, alien), "joint (index 5");
	assert_false(scree_joint_is_valid(NULL, joint) || scree_joint_is_valid(world, gone));
	assert_false(scree_joint_is_valid(world, SCREE_NULL_JOINT) || scree_joint_is_valid(world, alien));
	assert_true(scree_joint_is_valid(world, joint) && scree_joint_is_valid(world, weld));

	INVALID(scree_world_get_joints, (NULL, listed, 2, &count), "world is null");
	INVALID(scree_world_get_joints, (world, NULL, 2, &count), "joints is null");
	INVALID(scree_world_get_joints, (world, listed, -1, &count), "capacity is -1");
	INVALID(scree_world_get_joints, (world, listed, 2, NULL), "count is null");
	INVALID(scree_body_get_joints, (NULL, body, listed, 2, &count), "world is null");
	INVALID(scree_body_get_joints, (world, body, NULL, 2, &count), "joints is null");
	INVALID(scree_body_get_joints, (world, body, listed, -1, &count), "capacity is -1");
	INVALID(scree_body_get_joints, (world, body, listed, 2, NULL), "count is null");
	STALE(scree_body_get_joints, (world, stale, listed, 2, &count), "body (index 4");
	STALE(scree_body_get_joints, (world, SCREE_NULL_BODY, listed, 2, &count), "body is null");
}

static void changes(void** state)
{
	(void)state;
	scree_joint both[2] = {joint, gone};
	float values[2] = {1.0f, NAN};
	scree_pose poses[2] = {good_pose, good_pose}, bad = good_pose;
	bad.position.y = INFINITY;
#define BATCH(function, values_name)                                                    \
	STALE(function, (world, both, SCREE_ALONG, values, 2), "joints[1] (index 2");       \
	INVALID(function, (world, NULL, SCREE_ALONG, values, 2), "joints is null");         \
	INVALID(function, (world, both, SCREE_ALONG, NULL, 2), values_name " is null");     \
	INVALID(function, (world, both, SCREE_ALONG, values, -1), "count is -1");           \
	INVALID(function, (world, both, (scree_coordinate)3, values, 1), "which is 3");     \
	INVALID(function, (NULL, both, SCREE_ALONG, values, 1), "world is null");           \
	both[1] = weld;                                                                     \
	INVALID(function, (world, both, SCREE_ALONG, values, 2), values_name "[1] is nan"); \
	both[1] = gone
	BATCH(scree_joints_set_targets, "targets");
	BATCH(scree_joints_set_motor_speeds, "speeds");
#undef BATCH
#define ONE(function, name)                                                         \
	STALE(function, (world, gone, SCREE_ALONG, 1.0f), "joint (index 2");            \
	STALE(function, (world, SCREE_NULL_JOINT, SCREE_ALONG, 1.0f), "joint is null"); \
	INVALID(function, (world, joint, (scree_coordinate)5, 1.0f), "which is 5");     \
	INVALID(function, (world, joint, SCREE_ALONG, 2e5f), name " is 200000");        \
	INVALID(function, (NULL, joint, SCREE_ALONG, 1.0f), "world is null")
	ONE(scree_joint_set_target, "target");
	ONE(scree_joint_set_motor_speed, "speed");
#undef ONE
	INVALID(scree_joint_set_frames, (world, joint, bad, good_pose), "frame_a.position.y is inf");
	INVALID(scree_joint_set_frames, (world, joint, good_pose, bad), "frame_b.position.y is inf");
	STALE(scree_joint_set_frames, (world, gone, good_pose, good_pose), "joint (index 2");
	INVALID(scree_joint_set_frames, (NULL, joint, good_pose, good_pose), "world is null");
	STALE(scree_joints_set_frames, (world, both, poses, poses, 2), "joints[1] (index 2");
	INVALID(scree_joints_set_frames, (world, both, NULL, poses, 2), "frames_a is null");
	INVALID(scree_joints_set_frames, (world, both, poses, NULL, 2), "frames_b is null");
	both[1] = weld;
	poses[1] = bad;
	INVALID(scree_joints_set_frames, (world, both, poses, poses, 2), "frames_a[1].position.y is inf");

	INVALID(scree_joint_set_stiffness, (world, joint, -1.0f, 1.0f), "hertz is -1");
	INVALID(scree_joint_set_stiffness, (world, joint, 2e6f, 1.0f), "hertz is 2000000");
	INVALID(scree_joint_set_stiffness, (world, joint, 1.0f, NAN), "damping_ratio is nan");
	INVALID(scree_joint_set_stiffness, (NULL, joint, 1.0f, 1.0f), "world is null");
	STALE(scree_joint_set_stiffness, (world, gone, 1.0f, 1.0f), "joint (index 2");
	INVALID(scree_joint_set_thresholds, (world, joint, -1.0f, 1.0f, true), "force is -1");
	INVALID(scree_joint_set_thresholds, (world, joint, 1.0f, INFINITY, true), "torque is inf");
	INVALID(scree_joint_set_thresholds, (NULL, joint, 1.0f, 1.0f, true), "world is null");
	STALE(scree_joint_set_thresholds, (world, gone, 1.0f, 1.0f, true), "joint (index 2");
	const bool enabled[2] = {false, false};
	both[1] = gone;
	INVALID(scree_joints_set_enabled, (world, both, NULL, 2), "enabled is null");
	INVALID(scree_joints_set_enabled, (world, NULL, enabled, 2), "joints is null");
	STALE(scree_joints_set_enabled, (world, both, enabled, 2), "joints[1] (index 2");
	assert_true(scree_joint_is_enabled(world, both[0]));
	both[1] = weld;
	INVALID(scree_joint_set_enabled, (NULL, joint, true), "world is null");
	STALE(scree_joint_set_enabled, (world, gone, true), "joint (index 2");
	assert_false(scree_joint_is_enabled(world, gone) || scree_joint_is_enabled(NULL, joint));
	INVALID(scree_joint_set_elliptic, (NULL, joint, true), "world is null");
	STALE(scree_joint_set_elliptic, (world, gone, true), "joint (index 2");
	INVALID(scree_joint_set_collide_connected, (NULL, joint, true), "world is null");
	STALE(scree_joint_set_collide_connected, (world, gone, true), "joint (index 2");
	INVALID(scree_joint_set_user, (NULL, joint, 1), "world is null");
	STALE(scree_joint_set_user, (world, gone, 1), "joint (index 2");
}

// Some functions of the interface are inline and pass the size of a struct to another function. Error messages contain
// the name of the inline function, which the user calls.
static void readings(void** state)
{
	(void)state;
	scree_joint both[2] = {joint, gone};
	scree_joint_state states[2];
	scree_joint_event events[2];
	scree_joint_def def;
	int count;
	INVALID(scree_joint_get_def, (NULL, joint, &def), "world is null");
	INVALID(scree_joint_get_def, (world, joint, NULL), "def is null");
	STALE(scree_joint_get_def, (world, gone, &def), "joint (index 2");
	INVALID(scree_joints_get_states, (NULL, both, states, 2), "world is null");
	INVALID(scree_joints_get_states, (world, NULL, states, 2), "joints is null");
	INVALID(scree_joints_get_states, (world, both, NULL, 2), "states is null");
	INVALID(scree_joints_get_states, (world, both, states, -1), "count is -1");
	STALE(scree_joints_get_states, (world, both, states, 2), "joints[1] (index 2");
	INVALID(scree_world_get_joint_events, (NULL, events, 2, &count), "world is null");
	INVALID(scree_world_get_joint_events, (world, NULL, 2, &count), "events is null");
	INVALID(scree_world_get_joint_events, (world, events, -1, &count), "capacity is -1");
	INVALID(scree_world_get_joint_events, (world, events, 2, NULL), "count is null");
}

// A definition may be longer than that of this version. It is refused unless all members that this version does not
// have are 0.
static void unknown_members(void** state)
{
	(void)state;
	struct
	{
		scree_joint_def def;
		uint64_t more;
	} longer = {.def = good_def(), .more = 0};
	longer.def.size = (uint32_t)sizeof longer;
	longer.more = 1;
	INVALID(scree_joint_create, (world, &longer.def, NULL), "def");
	assert_int_equal(sizeof(scree_joint_def) % sizeof(uint64_t), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(definitions),     cmocka_unit_test(coordinates),      cmocka_unit_test(places),
	    cmocka_unit_test(handles),         cmocka_unit_test(changes),          cmocka_unit_test(readings),
	    cmocka_unit_test(unknown_members), cmocka_unit_test(couplings),        cmocka_unit_test(held_coordinates),
	    cmocka_unit_test(measures),        cmocka_unit_test(coupling_changes), cmocka_unit_test(locked_motors),
	};
	return cmocka_run_group_tests(tests, set_up, tear_down_bad_input);
}
