// SPDX-License-Identifier: MIT
// test_materials.c -- pairs of materials: friction, restitution, belts, and what ignores each other.
#include "world_support.h"

static scree_attribute make_surface(scree_world* world, float half_width, float half_height, int material)
{
	scree_attribute_def def = scree_attribute_def_default();
	scree_attribute attribute;
	assert_ok(scree_shape_make_box(half_width, half_height, &def.shape));
	def.material = material;
	assert_ok(scree_attribute_create(world, &def, &attribute));
	return attribute;
}

static scree_body put(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	def.attribute = attribute;
	def.reports = SCREE_REPORT_TOUCHES;
	scree_body body;
	assert_ok(scree_body_create(world, &def, &body));
	return body;
}

// a floor of material 1 whose top is at y = 0, and a box of material 2 on it
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
	assert_ok(scree_world_set_material_pair(world, a, b, &pair));
}

// A box slides v^2 / (2 mu g); without friction it goes on, also from the next step where it lay at rest.
static void friction(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	scree_body box = put_box(world, 0.5f);
	set(world, 2, 1, 0.25f, NAN, NAN, false);
	assert_ok(scree_body_set_linear_velocity(world, box, (scree_vec){5.0f, 0.0f}));
	step(world, 180);
	assert_near(pose_of(world, box).position.x, 25.0 / (2.0 * 0.25 * 10.0), 0.1);
	set(world, 1, 2, 0.0f, NAN, NAN, false);
	assert_ok(scree_body_set_linear_velocity(world, box, (scree_vec){5.0f, 0.0f}));
	step(world, 60);
	assert_near(velocity_of(world, box).linear.x, 5.0, 1e-5);
	assert_ok(scree_world_set_material_pair(world, 1, 2, NULL)); // 0.6, as the attributes say
	step(world, 60);
	assert_near(velocity_of(world, box).linear.x, 0.0, 1e-3);
	scree_world_destroy(world);
}

static void restitution(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	scree_body box = put_box(world, 2.5f);
	set(world, 1, 2, NAN, 1.0f, NAN, false);
	float highest = 0.0f;
	for (int k = 0; k < 75; ++k)
	{
		step(world, 1);
		if (k > 45)
			highest = fmaxf(highest, pose_of(world, box).position.y);
	}
	assert_near(highest, 2.5, 0.05);
	scree_world_destroy(world);
}

// A belt runs clockwise around the shape: what lies on it goes to the right, whichever of the two comes first.
static void belts(void** state)
{
	(void)state;
	for (int turn = 0; turn < 2; ++turn)
	{
		scree_world* world = make_world(-10.0f);
		scree_body box = put_box(world, 0.5f);
		step(world, 30);
		set(world, turn ? 1 : 2, turn ? 2 : 1, NAN, NAN, 2.0f, false);
		step(world, 120);
		assert_near(velocity_of(world, box).linear.x, 2.0, 1e-3);
		set(world, 1, 2, NAN, NAN, -1.0f, false);
		step(world, 120);
		assert_near(velocity_of(world, box).linear.x, -1.0, 1e-3);
		scree_world_destroy(world);
	}
}

// Bodies whose materials ignore each other end their touch, fall through at any speed, and start again; continuous collision does
// not stop them.
static void ignored(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	scree_body box = put_box(world, 0.5f);
	scree_events events;
	step(world, 2);
	assert_ok(scree_world_get_events(world, &events));
	set(world, 1, 2, NAN, NAN, NAN, true);
	step(world, 1);
	assert_ok(scree_world_get_events(world, &events));
	assert_int_equal(events.touches_ended_count, 1);
	assert_ok(scree_body_set_linear_velocity(world, box, (scree_vec){0.0f, -300.0f}));
	step(world, 10);
	assert_true(pose_of(world, box).position.y < -40.0f);
	assert_int_equal(contacts_of(world), 0);
	assert_ok(scree_body_set_pose(world, box, pose_at(0.0f, 0.4f, 0.0f)));
	assert_ok(scree_body_set_velocity(world, box, (scree_velocity){{0.0f, 0.0f}, 0.0f}));
	step(world, 1);
	set(world, 2, 1, NAN, NAN, NAN, false);
	step(world, 1);
	assert_ok(scree_world_get_events(world, &events));
	assert_int_equal(events.touches_began_count, 1);
	step(world, 60);
	assert_near(pose_of(world, box).position.y, 0.5, 0.01);
	scree_world_destroy(world);
}

// The table is in the hash before anything touches; its values can be read, and survive moves between devices.
static void told_and_moved(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	scree_body box = put_box(world, 3.0f);
	uint64_t before = hash_of(world);
	set(world, 200, 3, 0.5f, NAN, -2.0f, false);
	set(world, 1, 2, NAN, NAN, NAN, true);
	assert_true(hash_of(world) != before);
	scree_material_pair pair = {0};
	assert_ok(scree_world_get_material_pair(world, 3, 200, &pair));
	assert_true(pair.size == sizeof pair && pair.friction == 0.5f && isnan(pair.restitution));
	assert_true(pair.tangent_speed == -2.0f && !pair.ignored);
	assert_ok(scree_world_set_material_pair(world, 3, 200, NULL));
	assert_ok(scree_world_move(world, "cpu"));
	step(world, 120);
	assert_true(pose_of(world, box).position.y < -5.0f);
	assert_ok(scree_world_set_material_pair(world, 2, 1, NULL));
	assert_ok(scree_world_get_material_pair(world, 1, 2, &pair));
	assert_true(isnan(pair.friction) && !pair.ignored);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(friction), cmocka_unit_test(restitution),    cmocka_unit_test(belts),
	    cmocka_unit_test(ignored),  cmocka_unit_test(told_and_moved),
	};
	return RUN_ON_DEVICES(tests);
}
