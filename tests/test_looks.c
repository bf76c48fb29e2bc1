// SPDX-License-Identifier: MIT
// test_looks.c -- checks on the CPU and on OpenCL that a step of length 0 finds contacts and changes nothing else.
#include "support/make_bodies.h"
#include <float.h>
#include <string.h>

static void looking_finds_contacts(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.49f),
	           fast = add_crate(world, SCREE_BODY_DYNAMIC, 5.0f, 3.0f);
	throw_body(world, fast, 3, -300, 2);
	assert_int_equal(contacts_of(world), 0);
	scree_pose pose = pose_of(world, crate);
	update_contacts(world);
	scree_contact contact;
	int count;
	OK(scree_body_get_contacts(world, crate, &contact, 1, &count));
	assert_int_equal(count, 1);
	NEAR(contact.points[0].separation, -0.01, 1e-6);
	assert_true(contact.points[0].normal_impulse == 0.0f && contact.points[1].tangent_impulse == 0.0f);
	NEAR(counters_of(world).penetration, 0.01, 1e-6);
	assert_int_equal(contacts_with(world, fast), 0);
	expect_pose(world, crate, pose);
	expect_velocity(world, crate, 0, 0, 0);
	expect_velocity(world, fast, 3, -300, 2);
	scree_traffic traffic;
	OK(scree_world_get_traffic(world, &traffic));
	assert_true(traffic.constraints == 0 && traffic.constraint_bytes == 0);

	// the contact ends in the first step of 0 s after the crate is placed elsewhere
	OK(scree_body_set_pose(world, crate, pose_at(0.0f, 5.0f, 0.0f)));
	update_contacts(world);
	assert_int_equal(contacts_of(world), 0);
	assert_int_equal(counters_of(world).steps, 2);
	assert_true(counters_of(world).penetration == 0.0f);
	scree_world_destroy(world);
}

static void looking_changes_nothing_else(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body crates[5];
	for (int k = 0; k < 5; ++k)
		crates[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f + (float)k);
	run_steps(world, 100);
	scree_contact before[8], after[8];
	int count, again;
	update_contacts(world);
	OK(scree_world_get_contacts(world, before, 8, &count));
	assert_int_equal(count, 5);
	uint64_t hash = hash_of(world);
	for (int k = 0; k < 100; ++k)
	{
		update_contacts(world);
		assert_true(hash_of(world) == hash);
	}
	OK(scree_world_get_contacts(world, after, 8, &again));
	assert_int_equal(again, count);
	assert_memory_equal(before, after, (size_t)count * sizeof *before);

	// the impulses are unchanged: the sum of those on the top crate is m g times the length of a substep; a force acts
	// only in the next step that is longer than 0 s
	double load = 0.0;
	OK(scree_body_get_contacts(world, crates[4], after, 8, &again));
	assert_int_equal(again, 1);
	for (int k = 0; k < 2; ++k)
		load += after[0].points[k].normal_impulse;
	NEAR(load, 10.0 * STEP / 4.0, 1e-3);
	scree_velocity v = velocity_of(world, crates[4]);
	OK(scree_body_apply_force(world, crates[4], (scree_vec){0.0f, 70.0f}));
	update_contacts(world);
	expect_velocity(world, crates[4], v.linear.x, v.linear.y, v.angular);
	run_steps(world, 1);
	NEAR(velocity_of(world, crates[4]).linear.y, 60.0 * STEP, 1e-2);
	run_steps(world, 1);
	NEAR(velocity_of(world, crates[4]).linear.y, 50.0 * STEP, 1e-2);

	// a pile stays at rest if each step is followed by a step of length 0
	for (int k = 0; k < 60; ++k)
	{
		run_steps(world, 1);
		update_contacts(world);
	}
	for (int k = 0; k < 5; ++k)
		NEAR(pose_of(world, crates[k]).position.y, 0.5 + k, 0.02);
	scree_world_destroy(world);
}

static void no_time_is_no_error(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	update_contacts(world); // the world has no contacts yet
	OK(scree_world_step(world, -0.0f, 1));
	scree_attribute_def ball = scree_attribute_def_default();
	ball.shape = circle_shape(0.5f);
	ball.restitution = 1.0f;
	ball.rolling_resistance = 0.1f;
	scree_attribute attribute = add_attribute(world, &ball);
	add_floor(world);
	scree_body_def def = scree_body_def_default();
	def.attribute = attribute;
	def.pose.position.y = 0.49f;
	def.velocity.angular = 1000.0f;
	scree_body body = create_body(world, &def);
	OK(scree_body_apply_force(world, body, (scree_vec){FLT_MAX, FLT_MAX}));
	OK(scree_body_apply_force(world, body, (scree_vec){FLT_MAX, FLT_MAX}));
	update_contacts(world);
	assert_int_equal(contacts_of(world), 1);
	assert_int_equal(counters_of(world).frozen_bodies, 0);
	expect_velocity(world, body, 0, 0, 1000.0f);
	assert_int_equal(scree_world_step(world, 1e-10f, 1), SCREE_ERROR_INVALID);
	assert_int_equal(scree_world_step(world, 0.0f, 0), SCREE_ERROR_INVALID);
	run_steps(world, 1);
	assert_int_equal(counters_of(world).frozen_bodies, 0);
	update_contacts(world);
	assert_int_equal(counters_of(world).frozen_bodies, 0);
	scree_world_destroy(world);
}

// A step of length 0 lays out the constraints of hubs. The solver uses this layout in later steps, even if the host
// lists a solve before it has read the counters. Formula: hash(device) = hash(cpu).
static void looking_lays_out_hubs(void** state)
{
	(void)state;
	const char* here = test_device;
	uint64_t hashes[2][8];
	for (int w = 0; w < 2; ++w)
	{
		test_device = w ? here : "cpu";
		scree_world* world = open_test_world(-10.0f);
		scree_attribute_def ball = scree_attribute_def_default();
		scree_body_def def = scree_body_def_default();
		ball.shape = circle_shape(0.5f);
		def.attribute = add_attribute(world, &ball);
		for (int k = 0; k < 40; ++k)
			OK(scree_body_create(world, &def, NULL));
		update_contacts(world);
		assert_true(counters_of(world).spokes > 32);
		for (int k = 0; k < 8; ++k)
		{
			OK(scree_world_step(world, k == 5 ? 0.0f : 0.001f, 4));
			hashes[w][k] = hash_of(world);
		}
		scree_world_destroy(world);
	}
	test_device = here;
	assert_memory_equal(hashes[0], hashes[1], sizeof hashes[0]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(looking_finds_contacts),
	    cmocka_unit_test(looking_changes_nothing_else),
	    cmocka_unit_test(no_time_is_no_error),
	    cmocka_unit_test(looking_lays_out_hubs),
	};
	return RUN_ON_DEVICES(tests);
}
