// SPDX-License-Identifier: MIT
// test_reading.c -- checks that a program can read and set values of bodies and of the world between two steps.
#include "support/make_bodies.h"
#include <string.h>

// One call returns the states of all living bodies in the order of their indices. These states equal those that are
// read body by body.
static void states_of_all(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body made[20];
	for (int k = 0; k < 20; ++k)
		made[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.25f, 1.1f * (float)k, 0.3f * (float)(k % 3));
	throw_body(world, made[3], 1.0f, 2.0f, 3.0f);
	run_steps(world, 3);
	OK(scree_body_destroy(world, made[5]));

	scree_body bodies[20];
	scree_body_state states[20];
	int count = 0;
	OK(scree_world_get_states(world, bodies, states, 20, &count));
	assert_int_equal(count, 19);
	for (int k = 0; k < count; ++k)
	{
		assert_true(scree_body_equals(bodies[k], made[k + (k >= 5)]));
		scree_pose pose = pose_of(world, bodies[k]);
		scree_velocity velocity = velocity_of(world, bodies[k]);
		assert_memory_equal(&pose, &states[k].pose, sizeof pose);
		assert_memory_equal(&velocity, &states[k].velocity, sizeof velocity);
	}
	OK(scree_world_get_states(world, NULL, states, 2, &count));
	assert_int_equal(count, 19);
	OK(scree_world_get_states(world, NULL, NULL, 0, &count));
	assert_int_equal(count, 19);
	scree_world_destroy(world);
}

// The definition of a body is read and used in another world. The new body moves like the first one, bit for bit.
static void definition_of_a_body(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_world* other = open_world(-10.0f);
	scree_body_def made = scree_body_def_default(), read = scree_body_def_default();
	made.pose = (scree_pose){{1.0f, 2.0f}, scree_rot_make(0.3f)};
	made.velocity = (scree_velocity){{3.0f, -4.0f}, 0.5f};
	made.gravity_scale = -0.5f;
	made.linear_damping = 0.25f;
	made.angular_damping = 2.0f;
	made.locks = SCREE_LOCK_X;
	made.user = 7;
	scree_body body, copy;
	OK(scree_body_create(world, &made, &body));
	run_steps(world, 5);
	OK(scree_body_get_def(world, body, &read));
	scree_pose pose = pose_of(world, body);
	assert_memory_equal(&read.pose, &pose, sizeof pose);
	assert_int_equal(read.type, SCREE_BODY_DYNAMIC);
	assert_true(read.velocity.linear.x == 0.0f); // the body is locked in x
	assert_true(read.gravity_scale == -0.5f && read.linear_damping == 0.25f && read.angular_damping == 2.0f);
	assert_true(read.locks == SCREE_LOCK_X && read.user == 7 && !read.disabled);
	assert_true(scree_attribute_is_null(read.attribute));

	OK(scree_body_create(other, &read, &copy));
	run_steps(world, 5);
	run_steps(other, 5);
	scree_pose expected = pose_of(world, body), moved = pose_of(other, copy);
	assert_memory_equal(&expected, &moved, sizeof moved);

	OK(scree_body_set_enabled(world, body, false));
	OK(scree_body_get_def(world, body, &read));
	assert_true(read.disabled);
	assert_true(read.velocity.linear.y == velocity_of(world, body).linear.y);
	OK(scree_body_destroy(world, body));
	scree_world_destroy(other);
	scree_world_destroy(world);
}

// Checks a corner of a rotating box, turned by 90 degrees: its position in the world, the conversion of this position
// back to local coordinates, and its velocity.
static void points_of_a_body(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body box = add_box(world, SCREE_BODY_DYNAMIC, 2.0f, 1.0f, 10.0f, 20.0f);
	OK(scree_body_set_pose(world, box, (scree_pose){{10.0f, 20.0f}, scree_rot_make(1.57079633f)}));
	throw_body(world, box, 5.0f, 0.0f, 2.0f);
	scree_vec point, local, velocity;
	OK(scree_body_get_world_point(world, box, (scree_vec){2.0f, 1.0f}, &point));
	NEAR(point.x, 9.0, 1e-5);
	NEAR(point.y, 22.0, 1e-5);
	OK(scree_body_get_local_point(world, box, point, &local));
	NEAR(local.x, 2.0, 1e-5);
	NEAR(local.y, 1.0, 1e-5);
	OK(scree_body_get_point_velocity(world, box, point, &velocity));
	NEAR(velocity.x, 5.0 - 2.0 * 2.0, 1e-5);
	NEAR(velocity.y, 2.0 * -1.0, 1e-5);
	scree_world_destroy(world);
}

// A lower maximum speed applies in the next step. A new restitution threshold applies to the next impact.
static void tuning_between_steps(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_attribute_def ball = surface_of(circle_shape(0.5f));
	ball.restitution = 1.0f;
	add_floor(world);
	scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &ball), 0.0f, 5.5f, 0.0f);
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	assert_true(tuning.max_speed == 400.0f && tuning.contact_hertz == 40.0f);
	run_steps(world, 30);
	assert_true(velocity_of(world, body).linear.y < -4.0f);
	tuning.max_speed = 2.0f;
	tuning.restitution_threshold = 3.0f;
	OK(scree_world_set_tuning(world, &tuning));
	run_steps(world, 1);
	NEAR(velocity_of(world, body).linear.y, -2.0, 1e-4);
	run_steps(world, 300);
	NEAR(velocity_of(world, body).linear.y, 0.0, 1e-3);
	NEAR(position_of(world, body).y, 0.5, 0.01);

	scree_vec gravity;
	OK(scree_world_get_gravity(world, &gravity));
	assert_true(gravity.x == 0.0f && gravity.y == -10.0f);
	scree_world_destroy(world);
}

// Sets masses in a batch, which has the same effect as single calls. If one mass is refused, the batch sets no mass.
static void masses_in_a_batch(void** state)
{
	(void)state;
	scree_world* worlds[2];
	uint64_t hashes[2];
	const scree_mass masses[3] = {{2.0f, 1.0f, {0.0f, 0.1f}}, {5.0f, 0.0f, {0.0f, 0.0f}}, {0.1f, 0.2f, {0.2f, 0.0f}}};
	for (int w = 0; w < 2; ++w)
	{
		scree_world* world = worlds[w] = open_world(-10.0f);
		scree_body bodies[3], floor = add_floor(world);
		for (int k = 0; k < 3; ++k)
			bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.6f * (float)k, 0.5f + 1.1f * (float)k);
		for (int k = 0; w == 0 && k < 3; ++k)
			OK(scree_body_set_mass(world, bodies[k], masses[k]));
		if (w == 1)
		{
			scree_body mixed[3] = {bodies[0], bodies[1], floor};
			uint64_t before = hash_of(world);
			assert_int_equal(scree_bodies_set_masses(world, mixed, masses, 3), SCREE_ERROR_INVALID);
			assert_non_null(strstr(scree_error(), "bodies[2] is not dynamic: it has no mass"));
			assert_int_equal(hash_of(world), before);
			OK(scree_bodies_set_masses(world, bodies, masses, 3));
		}
		run_steps(world, 60);
		hashes[w] = hash_of(world);
	}
	assert_int_equal(hashes[0], hashes[1]);
	scree_world_destroy(worlds[0]);
	scree_world_destroy(worlds[1]);
}

static void handles_compare(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body a = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 1.0f, 0.0f, 0.0f);
	scree_body b = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 1.0f, 9.0f, 0.0f);
	assert_true(scree_body_equals(a, a) && !scree_body_equals(a, b) && !scree_body_is_null(a));
	assert_true(scree_body_is_null(SCREE_NULL_BODY) && !scree_body_is_valid(world, SCREE_NULL_BODY));
	assert_true(scree_collidable_is_null(SCREE_NULL_COLLIDABLE) && scree_attribute_is_null(SCREE_NULL_ATTRIBUTE));
	scree_world_destroy(world);
}

// A contact names the two bodies and the user words of its collidables.
static void contacts_name_bodies(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body floor = add_floor(world), box = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_collidable part;
	int count;
	OK(scree_body_get_collidables(world, box, &part, 1, &count));
	OK(scree_collidable_set_user(world, part, 77));
	run_steps(world, 2);
	scree_contact contact;
	OK(scree_world_get_contacts(world, &contact, 1, &count));
	assert_int_equal(count, 1);
	bool first = scree_collidable_equals(contact.a, part);
	assert_true(scree_body_equals(first ? contact.body_a : contact.body_b, box));
	assert_true(scree_body_equals(first ? contact.body_b : contact.body_a, floor));
	assert_int_equal(first ? contact.user_a : contact.user_b, 77);
	assert_int_equal(first ? contact.user_b : contact.user_a, 0);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(definition_of_a_body), cmocka_unit_test(states_of_all),
	    cmocka_unit_test(points_of_a_body),     cmocka_unit_test(tuning_between_steps),
	    cmocka_unit_test(handles_compare),      cmocka_unit_test(contacts_name_bodies),
	    cmocka_unit_test(masses_in_a_batch),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
