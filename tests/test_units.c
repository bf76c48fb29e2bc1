// SPDX-License-Identifier: MIT
// test_units.c -- checks that a world with another unit of length moves as the same world in metres.
//
// Formula: with a power of two as unit, hash(world in units) = hash(world in metres), and each result is that in metres times a
// power of the unit. With other units the motion is equal up to rounding, and has the same bits on all devices.
#include "support/second_device.h"
#include "support/unit_scene.h"
#include <float.h>
#include <math.h>
#include <string.h>

#define STEPS 90

static uint64_t hash_of_world(scree_world* world)
{
	uint64_t hash;
	OK(scree_world_get_hash(world, &hash));
	return hash;
}

// Runs the scene, and compares it with that in metres every ten steps. exact: the unit is a power of two.
static uint64_t compare(const char* device, int lanes, float unit, bool exact)
{
	static float metres[UNIT_RESULTS], units[UNIT_RESULTS];
	UnitScene a, b;
	unit_scene_open(&a, device, lanes, 1.0f);
	unit_scene_open(&b, device, lanes, unit);
	assert_true(scree_world_get_length_unit(b.world) == unit);
	for (int step = 0; step < (exact ? STEPS : 10); ++step)
	{
		unit_scene_step(&a, step);
		unit_scene_step(&b, step);
		if (step % 10 != 9)
			continue;
		int count = unit_scene_results(&a, metres), other = unit_scene_results(&b, units);
		assert_int_equal(count, other);
		for (int k = 0; k < count; ++k)
			if (exact ? memcmp(metres + k, units + k, sizeof *units) != 0
			          : fabsf(metres[k] - units[k]) > 1e-3f * (1.0f + fabsf(metres[k])))
				fail_msg("unit %g, step %d, result %d of %d: %.9g m, %.9g", (double)unit, step, k, count,
				         (double)metres[k], (double)units[k]);
		if (exact)
			assert_true(hash_of_world(a.world) == hash_of_world(b.world));
	}
	uint64_t hash = hash_of_world(b.world);
	scree_world_destroy(a.world);
	scree_world_destroy(b.world);
	return hash;
}

static void powers_of_two_have_the_bits_of_metres(void** state)
{
	(void)state;
	compare("cpu", 0, 64.0f, true);
	compare("cpu", 1, 0.00390625f, true);
	compare("cpu", 4, 4096.0f, true);
	if (second_device[0])
		compare(second_device, 0, 64.0f, true);
}

static void other_units_have_the_same_bits_on_all_devices(void** state)
{
	(void)state;
	uint64_t hash = compare("cpu", 0, 100.0f, false);
	assert_true(compare("cpu", 1, 100.0f, false) == hash);
	assert_true(compare("cpu", 16, 100.0f, false) == hash);
	if (second_device[0])
		assert_true(compare(second_device, 0, 100.0f, false) == hash);
	compare("cpu", 0, 39.37008f, false);
	compare("cpu", 0, 0.001f, false);
}

static scree_world* pixels(float unit, scree_body* top)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.gravity = (scree_vec){0.0f, -1000.0f};
	def.length_unit = unit;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	scree_attribute_def crate = scree_attribute_def_default();
	scree_attribute floor, box;
	OK(scree_shape_make_box(3000.0f, 50.0f, &crate.shape));
	OK(scree_attribute_create(world, &crate, &floor));
	OK(scree_shape_make_box(50.0f, 50.0f, &crate.shape));
	OK(scree_attribute_create(world, &crate, &box));
	scree_body_def body = scree_body_def_default();
	body.type = SCREE_BODY_STATIC;
	body.pose.position.y = -50.0f;
	body.attribute = floor;
	OK(scree_body_create(world, &body, NULL));
	body.type = SCREE_BODY_DYNAMIC;
	body.attribute = box;
	for (int k = 0; k < 10; ++k)
	{
		body.pose.position.y = 50.0f + 100.0f * (float)k;
		OK(scree_body_create(world, &body, top));
	}
	return world;
}

// Ten crates of 100 pixels stand at default settings, fall asleep, and fall as fast as in metres.
static void crates_of_pixels_stand(void** state)
{
	(void)state;
	scree_body top;
	scree_world* world = pixels(100.0f, &top);
	for (int k = 0; k < 600; ++k)
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
	scree_pose pose;
	scree_counters counters;
	OK(scree_body_get_pose(world, top, &pose));
	NEAR(pose.position.x, 0.0, 1.0);
	NEAR(pose.position.y, 950.0, 5.0);
	OK(scree_world_get_counters(world, &counters));
	assert_int_equal(counters.asleep_bodies, 10);
	assert_true(counters.penetration < 1.0f);
	OK(scree_body_set_pose(world, top, (scree_pose){{0.0f, 10000.0f}, {1.0f, 0.0f}}));
	for (int k = 0; k < 60; ++k)
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
	scree_velocity velocity;
	OK(scree_body_get_velocity(world, top, &velocity));
	NEAR(velocity.linear.y, -1000.0, 1.0); // max_speed is 400 m/s: 40,000 pixels/s
	scree_world_destroy(world);
}

// A snapshot, a clone, a save and a recording keep the unit, and the bits.
static void states_keep_the_unit(void** state)
{
	(void)state;
	UnitScene s;
	unit_scene_open(&s, "cpu", 4, 100.0f);
	const void* bytes;
	size_t size;
	scree_world *metres, *clone, *again;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	OK(scree_world_create(&def, &metres));
	OK(scree_world_record(s.world, NULL));
	for (int step = 0; step < 20; ++step)
		unit_scene_step(&s, step);
	OK(scree_world_save(s.world, 0));
	OK(scree_world_snapshot(s.world, &bytes, &size));
	OK(scree_world_restore(metres, bytes, size));
	assert_true(scree_world_get_length_unit(metres) == 100.0f);
	OK(scree_world_clone(s.world, NULL, &clone));
	assert_true(scree_world_get_length_unit(clone) == 100.0f);
	scree_vec gravity;
	OK(scree_world_get_gravity(clone, &gravity));
	NEAR(gravity.y, -1000.0, 1e-3);
	scree_pose one, two;
	OK(scree_body_get_pose(metres, s.crates[0], &one));
	OK(scree_body_get_pose(s.world, s.crates[0], &two));
	assert_memory_equal(&one, &two, sizeof one);
	OK(scree_world_end_recording(s.world));
	uint64_t hash = hash_of_world(s.world);
	OK(scree_world_load(s.world, 0));
	assert_true(hash_of_world(s.world) == hash);
	OK(scree_world_get_recording(s.world, &bytes, &size));
	scree_replay* replay;
	OK(scree_replay_open(bytes, size, &replay));
	OK(scree_replay_create_world(replay, &def, &again));
	for (bool stepped = true; stepped;)
		OK(scree_replay_step(replay, again, &stepped));
	assert_true(hash_of_world(again) == hash);
	assert_true(scree_world_get_length_unit(again) == 100.0f);
	scree_replay_close(replay);
	scree_world_destroy(again);
	scree_world_destroy(clone);
	scree_world_destroy(metres);
	scree_world_destroy(s.world);
}

// Definitions come back as they were given, up to rounding; defaults without a bound stay so; a definition that a call completes
// keeps the bits of its other members.
static void definitions_come_back(void** state)
{
	(void)state;
	UnitScene s;
	unit_scene_open(&s, "cpu", 4, 30.0f);
	scree_joint_def joint;
	OK(scree_joint_get_def(s.world, s.spring, &joint));
	NEAR(joint.coordinates[SCREE_ALONG].upper, 75.0, 1e-4);
	NEAR(joint.coordinates[SCREE_ALONG].spring_push, 900.0, 1e-3);
	assert_true(joint.coordinates[SCREE_ALONG].spring_max == FLT_MAX && joint.force_threshold == FLT_MAX);
	OK(scree_joint_get_def(s.world, s.rack, &joint));
	NEAR(joint.ratio, 15.0, 1e-5);
	scree_field_def field;
	OK(scree_field_get_def(s.world, s.fields[2], &field));
	NEAR(field.quadratic_drag, 0.125 / 30.0, 1e-8);
	NEAR(field.spin_drag, 0.0625 * 900.0, 1e-4);
	OK(scree_field_get_def(s.world, s.fields[3], &field));
	NEAR(field.linear_drag, 2.0 / 900.0, 1e-8);
	scree_attribute_def attribute;
	OK(scree_attribute_get_def(s.world, s.box, &attribute));
	NEAR(attribute.density, 2.0 / 900.0, 1e-8);
	NEAR(attribute.shape.area, 0.5 * 900.0, 1e-3);
	scree_joint_def made = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	made.body_b = s.crates[0];
	made.coordinates[SCREE_ALONG].upper = 0.1f;
	made.frame_a.position.x = 7.0f;
	OK(scree_joint_def_place(s.world, &made, (scree_pose){{7.0f, 0.3f}, {1.0f, 0.0f}}));
	assert_true(made.coordinates[SCREE_ALONG].upper == 0.1f && made.frame_a.position.x == 7.0f);
	scree_world_destroy(s.world);
}

#define REFUSED(call, part)                               \
	do                                                    \
	{                                                     \
		assert_int_equal(call, SCREE_ERROR_INVALID);      \
		if (!strstr(scree_error(), part))                 \
			fail_msg("%s lacks %s", scree_error(), part); \
	} while (0)

// Ranges follow the unit; messages name it; null, NaN and stale handles are refused as in metres.
static void strange_arguments_are_refused(void** state)
{
	(void)state;
	scree_world* world;
	scree_world_def def = scree_world_def_default();
	const float refused[] = {-1.0f, NAN, INFINITY, 0.0009f, 2e6f};
	for (int k = 0; k < 5; ++k)
	{
		def.length_unit = refused[k];
		REFUSED(scree_world_create(&def, &world), "def.length_unit");
	}
	scree_body top;
	world = pixels(100.0f, &top);
	scree_pose pose = {{1.001e7f, 0.0f}, {1.0f, 0.0f}};
	REFUSED(scree_body_set_pose(world, top, pose), "length_unit is 100");
	pose.position.x = 9.999e6f; // 99,990 m
	OK(scree_body_set_pose(world, top, pose));
	pose.position.x = NAN;
	REFUSED(scree_body_set_pose(world, top, pose), "pose");
	assert_int_equal(scree_body_set_pose(world, SCREE_NULL_BODY, pose), SCREE_ERROR_STALE);
	assert_int_equal(scree_body_set_pose(NULL, top, pose), SCREE_ERROR_INVALID);
	REFUSED(scree_bodies_set_poses(world, NULL, NULL, -1), "count");
	REFUSED(scree_bodies_set_poses(world, &top, NULL, 1), "poses");
	REFUSED(scree_body_create(world, NULL, NULL), "def");
	REFUSED(scree_world_get_gravity(world, NULL), "gravity");
	scree_attribute attribute;
	scree_attribute_def thin = scree_attribute_def_default();
	OK(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.09f, &thin.shape)); // 0.9 mm
	REFUSED(scree_attribute_create(world, &thin, &attribute), "length_unit is 100");
	thin.size = 3;
	REFUSED(scree_attribute_create(world, &thin, &attribute), "size");
	assert_int_equal(scree_world_share_memory(world, 1, 4096), SCREE_ERROR_NOT_SUPPORTED);
	assert_non_null(strstr(scree_error(), "length_unit is 100"));
	assert_true(scree_world_get_length_unit(NULL) == 0.0f);
	scree_world_destroy(world);
}

// A world in kilometres: sizes from 1 m down to 1 mm, and places up to 100 km, by shapes that are made in metres.
static void shapes_scale(void** state)
{
	(void)state;
	scree_shape shape;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.length_unit = 0.001f;
	scree_world* world;
	OK(scree_world_create(&def, &world));
	scree_attribute_def grain = scree_attribute_def_default();
	OK(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.0011f, &shape));
	OK(scree_shape_scale(&shape, 0.001f, &grain.shape));
	grain.density = 1e6f; // kg/km^2
	scree_body_def body = scree_body_def_default();
	OK(scree_attribute_create(world, &grain, &body.attribute));
	body.pose.position.x = 99.0f;
	OK(scree_body_create(world, &body, NULL));
	OK(scree_world_step(world, 1.0f / 60.0f, 4));
	scree_world_destroy(world);
	REFUSED(scree_shape_scale(NULL, 1.0f, &shape), "shape");
	REFUSED(scree_shape_scale(&shape, 1.0f, NULL), "scaled");
	REFUSED(scree_shape_scale(&shape, 0.0f, &shape), "factor");
	REFUSED(scree_shape_scale(&shape, NAN, &shape), "factor");
	OK(scree_shape_make_box(1e5f, 1e5f, &shape));
	REFUSED(scree_shape_scale(&shape, 1e9f, &shape), "scaled");
}

static void constants_are_listed(void** state)
{
	(void)state;
	scree_constant constants[100];
	int count, all;
	OK(scree_units(NULL, 0, &all));
	OK(scree_units(constants, 100, &count));
	assert_true(count == all && count > 40 && count < 100);
	REFUSED(scree_units(NULL, 1, &count), "constants");
	REFUSED(scree_units(constants, 1, NULL), "count");
	for (int k = 0; k < all; ++k)
	{
		assert_true(constants[k].value > 0.0f && constants[k].power != 0);
		assert_true(strlen(constants[k].name) > 2 && strlen(constants[k].unit) > 0 &&
		            strlen(constants[k].meaning) > 10);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(powers_of_two_have_the_bits_of_metres),
	    cmocka_unit_test(other_units_have_the_same_bits_on_all_devices),
	    cmocka_unit_test(crates_of_pixels_stand),
	    cmocka_unit_test(states_keep_the_unit),
	    cmocka_unit_test(definitions_come_back),
	    cmocka_unit_test(strange_arguments_are_refused),
	    cmocka_unit_test(shapes_scale),
	    cmocka_unit_test(constants_are_listed),
	};
	return cmocka_run_group_tests(tests, find_second_device, memory_is_released);
}
