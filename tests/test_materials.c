// SPDX-License-Identifier: MIT
// test_materials.c -- checks material pairs: friction, restitution, tangent speed, and materials that ignore each
// other.
#include "support/make_bodies.h"
#include <math.h>

static scree_attribute make_surface(scree_world* world, float half_width, float half_height, int material)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = box_shape(half_width, half_height);
	def.material = material;
	return add_attribute(world, &def);
}

static scree_body put(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	def.attribute = attribute;
	def.reports = SCREE_REPORT_TOUCHES;
	return create_body(world, &def);
}

// Adds a floor of material 1 with its top at y = 0, and a box of material 2. y: height of the center of the box, m.
// Returns the box.
static scree_body put_box(scree_world* world, float y)
{
	put(world, SCREE_BODY_STATIC, make_surface(world, 50.0f, 1.0f, 1), 0.0f, -1.0f);
	return put(world, SCREE_BODY_DYNAMIC, make_surface(world, 0.5f, 0.5f, 2), 0.0f, y);
}

static void set(scree_world* world, int a, int b, float friction, float restitution, float speed, bool ignored)
{
	scree_material_pair pair = scree_material_pair_default();
	pair.friction = friction;
	pair.restitution = restitution;
	pair.tangent_speed = speed;
	pair.ignored = ignored;
	OK(scree_world_set_material_pair(world, a, b, &pair));
}

// A box slides for the distance v^2 / (2 mu g), with the friction mu. Without friction it keeps its speed. Changes of
// friction apply from the next step on, even to a box at rest.
static void friction(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body box = put_box(world, 0.5f);
	set(world, 2, 1, 0.25f, NAN, NAN, false);
	OK(scree_body_set_linear_velocity(world, box, (scree_vec){5.0f, 0.0f}));
	run_steps(world, 180);
	NEAR(pose_of(world, box).position.x, 25.0 / (2.0 * 0.25 * 10.0), 0.1);
	set(world, 1, 2, 0.0f, NAN, NAN, false);
	OK(scree_body_set_linear_velocity(world, box, (scree_vec){5.0f, 0.0f}));
	run_steps(world, 60);
	NEAR(velocity_of(world, box).linear.x, 5.0, 1e-5);
	OK(scree_world_set_material_pair(world, 1, 2, NULL)); // the friction of the attributes, 0.6, applies again
	run_steps(world, 60);
	NEAR(velocity_of(world, box).linear.x, 0.0, 1e-3);
	scree_world_destroy(world);
}

static void restitution(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body box = put_box(world, 2.5f);
	set(world, 1, 2, NAN, 1.0f, NAN, false);
	float highest = 0.0f;
	for (int k = 0; k < 75; ++k)
	{
		run_steps(world, 1);
		if (k > 45)
			highest = fmaxf(highest, pose_of(world, box).position.y);
	}
	NEAR(highest, 2.5, 0.05);
	scree_world_destroy(world);
}

// A belt moves its surface clockwise around its shape, so a box on the belt moves to the right. The order of the two
// materials in a call does not matter.
static void belts(void** state)
{
	(void)state;
	for (int turn = 0; turn < 2; ++turn)
	{
		scree_world* world = open_test_world(-10.0f);
		scree_body box = put_box(world, 0.5f);
		run_steps(world, 30);
		set(world, turn ? 1 : 2, turn ? 2 : 1, NAN, NAN, 2.0f, false);
		run_steps(world, 120);
		NEAR(velocity_of(world, box).linear.x, 2.0, 1e-3);
		set(world, 1, 2, NAN, NAN, -1.0f, false);
		run_steps(world, 120);
		NEAR(velocity_of(world, box).linear.x, -1.0, 1e-3);
		scree_world_destroy(world);
	}
}

// Two bodies with materials that ignore each other end their touch. They pass through each other at any speed, because
// continuous collision also ignores them. Their touch begins again when the materials no longer ignore each other.
static void ignored(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body box = put_box(world, 0.5f);
	run_steps(world, 2);
	scree_events events = events_of(world);
	set(world, 1, 2, NAN, NAN, NAN, true);
	run_steps(world, 1);
	events = events_of(world);
	assert_int_equal(events.touches_ended_count, 1);
	OK(scree_body_set_linear_velocity(world, box, (scree_vec){0.0f, -300.0f}));
	run_steps(world, 10);
	assert_true(pose_of(world, box).position.y < -40.0f);
	assert_int_equal(contacts_of(world), 0);
	OK(scree_body_set_pose(world, box, pose_at(0.0f, 0.4f, 0.0f)));
	throw_body(world, box, 0.0f, 0.0f, 0.0f);
	run_steps(world, 1);
	set(world, 2, 1, NAN, NAN, NAN, false);
	run_steps(world, 1);
	events = events_of(world);
	assert_int_equal(events.touches_began_count, 1);
	run_steps(world, 60);
	NEAR(pose_of(world, box).position.y, 0.5, 0.01);
	scree_world_destroy(world);
}

// The table of material pairs is part of the hash, even if nothing touches. Its values can be read, and remain after a
// move to another device.
static void reported_and_moved(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body box = put_box(world, 3.0f);
	uint64_t before = hash_of(world);
	set(world, 200, 3, 0.5f, NAN, -2.0f, false);
	set(world, 1, 2, NAN, NAN, NAN, true);
	assert_true(hash_of(world) != before);
	scree_material_pair pair = {0};
	OK(scree_world_get_material_pair(world, 3, 200, &pair));
	assert_true(pair.size == sizeof pair && pair.friction == 0.5f && isnan(pair.restitution));
	assert_true(pair.tangent_speed == -2.0f && !pair.ignored);
	OK(scree_world_set_material_pair(world, 3, 200, NULL));
	OK(scree_world_move(world, "cpu"));
	run_steps(world, 120);
	assert_true(pose_of(world, box).position.y < -5.0f);
	OK(scree_world_set_material_pair(world, 2, 1, NULL));
	OK(scree_world_get_material_pair(world, 1, 2, &pair));
	assert_true(isnan(pair.friction) && !pair.ignored);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(friction), cmocka_unit_test(restitution),        cmocka_unit_test(belts),
	    cmocka_unit_test(ignored),  cmocka_unit_test(reported_and_moved),
	};
	return RUN_ON_DEVICES(tests);
}
