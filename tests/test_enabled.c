// SPDX-License-Identifier: MIT
// test_enabled.c -- checks bodies that are disabled and enabled, on the CPU and on OpenCL.
#include "support/make_bodies.h"
#include "world/world.h"

static void disabled_bodies_take_no_part(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body low = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f),
	           high = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f);
	run_steps(world, 30);
	assert_int_equal(contacts_of(world), 2);
	assert_true(scree_body_is_enabled(world, low));
	scree_pose pose = pose_of(world, low);
	throw_body(world, low, 1, 2, 3);
	OK(scree_body_set_enabled(world, low, false));
	assert_false(scree_body_is_enabled(world, low));
	assert_int_equal(contacts_of(world), 0); // contacts end when the body is disabled, before the next step
	scree_render_row rows[4];
	int count;
	OK(scree_world_get_render_rows(world, rows, 4, &count));
	assert_true(count == 3 && rows[collidable_of(world, low).index - 1].attribute == -1);
	run_steps(world, 120);
	expect_pose(world, low, pose);
	expect_velocity(world, low, 1, 2, 3);
	NEAR(pose_of(world, high).position.y, 0.5, 0.02);
	assert_int_equal(contacts_of(world), 1);
	assert_int_equal(counters_of(world).contacts, 1);
	assert_int_equal(counters_of(world).bodies, 3);
	scree_body_state states[3];
	OK(scree_world_get_states(world, NULL, states, 3, &count));
	assert_true(states[1].velocity.linear.y == 2.0f && states[1].velocity.angular == 3.0f);

	// a disabled body accepts poses and impulses, but forces on it are lost
	pose = pose_at(10.0f, 4.0f, 0.5f);
	scree_mass mass = mass_of(world, low);
	OK(scree_body_set_pose(world, low, pose));
	OK(scree_body_set_linear_velocity(world, low, (scree_vec){0, 0}));
	OK(scree_body_apply_impulse(world, low, (scree_vec){5.0f * mass.mass, 0}));
	OK(scree_body_apply_force(world, low, (scree_vec){0, 1e6f}));
	expect_velocity(world, low, 5, 0, 3);
	run_steps(world, 10);
	expect_pose(world, low, pose);
	expect_velocity(world, low, 5, 0, 3);
	OK(scree_body_set_enabled(world, low, true));
	run_steps(world, 1);
	NEAR(pose_of(world, low).position.x, 10.0 + 5.0 * STEP, 1e-5);
	NEAR(velocity_of(world, low).linear.y, -10.0 * STEP, 1e-5);
	NEAR(velocity_of(world, low).angular, 3.0, 1e-6);
	run_steps(world, 120);
	assert_int_equal(contacts_with(world, low), 1);
	scree_world_destroy(world);
}

// A body that is disabled and enabled between two steps starts new contacts. Nothing else of its state changes.
static void switching_twice_starts_contacts_anew(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	run_steps(world, 30);
	scree_body twice[2] = {body, body};
	const bool off_and_on[2] = {false, true};
	scree_velocity v = velocity_of(world, body);
	OK(scree_bodies_set_enabled(world, twice, off_and_on, 2));
	assert_true(scree_body_is_enabled(world, body));
	assert_int_equal(contacts_of(world), 0);
	expect_velocity(world, body, v.linear.x, v.linear.y, v.angular);
	update_contacts(world);
	assert_int_equal(contacts_of(world), 1);
	scree_contact contact;
	int count;
	OK(scree_world_get_contacts(world, &contact, 1, &count));
	assert_true(contact.points[0].normal_impulse == 0.0f);

	// a call with the current value changes nothing
	run_steps(world, 10);
	uint64_t before = hash_of(world);
	OK(scree_body_set_enabled(world, body, true));
	assert_true(hash_of(world) == before && contacts_of(world) == 1);
	OK(scree_body_set_enabled(world, body, false));
	uint64_t off = hash_of(world);
	assert_true(off != before);
	OK(scree_body_set_enabled(world, body, false));
	assert_true(hash_of(world) == off);
	scree_world_destroy(world);
}

// Changes to a disabled body apply when it is enabled: changes of collidables, filters, types, masses and gravity.
static void disabled_bodies_change(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	def.disabled = true;
	def.velocity.linear.x = 2.0f;
	scree_body body, beside = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	body = create_body(world, &def);
	assert_false(scree_body_is_enabled(world, body));
	run_steps(world, 60);
	assert_int_equal(contacts_of(world), 1);
	expect_velocity(world, body, 2, 0, 0);

	// the body gets a second collidable and loses the first
	scree_collidable_def more = scree_collidable_def_default();
	more.attribute = box_attribute(world, 0.25f, 0.5f);
	more.body = body;
	scree_collidable added = create_collidable(world, &more);
	OK(scree_collidable_destroy(world, collidable_of(world, beside)));
	scree_collidable list[2];
	int count;
	OK(scree_body_get_collidables(world, body, list, 2, &count));
	assert_int_equal(count, 2);
	OK(scree_collidable_destroy(world, list[0]));
	scree_mass mass = mass_of(world, body);
	NEAR(mass.mass, 0.5, 1e-6);
	OK(scree_body_set_type(world, body, SCREE_BODY_STATIC));
	run_steps(world, 1);
	expect_velocity(world, body, 0, 0, 0);
	OK(scree_body_set_enabled(world, body, true));
	scree_body rider = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f);
	run_steps(world, 60);
	NEAR(pose_of(world, rider).position.y, 1.5, 0.02);

	// the rider falls through the static body, which is disabled
	OK(scree_body_set_enabled(world, body, false));
	run_steps(world, 120);
	NEAR(pose_of(world, rider).position.y, 0.5, 0.02);
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	OK(scree_body_set_gravity_scale(world, body, 0.0f));
	OK(scree_collidable_set_filter(world, added, (scree_filter){2, 2, 0}));
	OK(scree_body_set_enabled(world, body, true));
	run_steps(world, 30);
	assert_int_equal(contacts_with(world, body), 0);
	NEAR(pose_of(world, body).position.y, 0.5, 1e-6);
	scree_world_destroy(world);
}

// A new body does not get the shape or the velocity of a disabled body whose slot it takes.
static void disabled_bodies_are_destroyed(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	for (int flushed = 0; flushed < 2; ++flushed)
		for (int many = 1; many <= 40; many += 39)
		{
			scree_body bodies[40];
			bool off[40] = {false};
			scree_body_def defs[40];
			for (int k = 0; k < many; ++k)
			{
				defs[k] = crate_def(world, SCREE_BODY_DYNAMIC, 2.0f * (float)k, 0.0f);
				defs[k].velocity.linear.y = 1.0f;
			}
			OK(scree_bodies_create(world, defs, many, bodies));
			run_steps(world, 1);
			OK(scree_bodies_set_enabled(world, bodies, off, many));
			if (flushed)
				run_steps(world, 1);
			OK(scree_bodies_destroy(world, bodies, many));
			if (flushed)
				run_steps(world, 1);
			for (int k = 0; k < many; ++k)
				defs[k].velocity.linear.y = 3.0f;
			OK(scree_bodies_create(world, defs, many, bodies));
			run_steps(world, 2);
			for (int k = 0; k < many; ++k)
			{
				NEAR(pose_of(world, bodies[k]).position.y, 6.0 * STEP, 1e-5);
				expect_velocity(world, bodies[k], 0, 3, 0);
			}
			OK(scree_bodies_destroy(world, bodies, many));
		}
	assert_int_equal(counters_of(world).bodies, 0);
	scree_world_destroy(world);
}

// A heap is disabled and enabled 30 times. The trees keep one leaf per collidable, and the heap still stands.
static void heaps_are_switched(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body bodies[60];
	bool on[60], off[60];
	for (int k = 0; k < 60; ++k)
	{
		bodies[k] = add_crate(world, k % 15 == 0 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, 1.1f * (float)(k % 10),
		                      0.5f + (float)(k / 10));
		on[k] = true;
		off[k] = false;
	}
	run_steps(world, 10);
	int contacts = contacts_of(world);
	assert_true(contacts > 50);
	for (int round = 0; round < 30; ++round)
	{
		OK(scree_bodies_set_enabled(world, bodies, off, 60));
		run_steps(world, 1 + round % 3);
		assert_int_equal(contacts_of(world), 0);
		assert_int_equal(counters_of(world).contacts, 0);
		OK(scree_bodies_set_enabled(world, bodies, on, 60));
		run_steps(world, 1 + round % 2);
	}
	run_steps(world, 60);
	assert_true(contacts_of(world) > 50);
	NEAR(pose_of(world, bodies[59]).position.y, 5.5, 0.1);
	for (int t = 0; t < 2; ++t)
		assert_true(world->pipeline.trees[t].tree.leaves <= 61);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(disabled_bodies_take_no_part), cmocka_unit_test(switching_twice_starts_contacts_anew),
	    cmocka_unit_test(disabled_bodies_change),       cmocka_unit_test(disabled_bodies_are_destroyed),
	    cmocka_unit_test(heaps_are_switched),
	};
	return RUN_ON_DEVICES(tests);
}
