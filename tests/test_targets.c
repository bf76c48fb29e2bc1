// SPDX-License-Identifier: MIT
// test_targets.c -- checks linear and angular velocities set separately, and target poses of kinematic bodies, on CPU
// and OpenCL.
#include "support/make_bodies.h"

static void velocities_are_set_apart(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body bodies[3];
	for (int k = 0; k < 3; ++k)
		bodies[k] = add_crate(world, (scree_body_type)k, 5.0f * (float)k, 0.0f);
	const scree_vec linear[3] = {{1, 2}, {3, 4}, {5, 6}};
	const float angular[3] = {7, 8, 9};
	OK(scree_bodies_set_linear_velocities(world, bodies, linear, 3));
	expect_velocity(world, bodies[2], 5, 6, 0);
	OK(scree_bodies_set_angular_velocities(world, bodies, angular, 3));
	expect_velocity(world, bodies[0], 0, 0, 0);
	expect_velocity(world, bodies[1], 3, 4, 8);
	expect_velocity(world, bodies[2], 5, 6, 9);
	OK(scree_body_set_linear_velocity(world, bodies[2], (scree_vec){-1, 0}));
	OK(scree_body_set_angular_velocity(world, bodies[1], -2));
	expect_velocity(world, bodies[1], 3, 4, -2);
	expect_velocity(world, bodies[2], -1, 0, 9);

	// velocities along locked directions remain 0
	OK(scree_body_set_locks(world, bodies[2], SCREE_LOCK_Y | SCREE_LOCK_ROTATION));
	OK(scree_body_set_linear_velocity(world, bodies[2], (scree_vec){2, 2}));
	OK(scree_body_set_angular_velocity(world, bodies[2], 2));
	expect_velocity(world, bodies[2], 2, 0, 0);
	scree_world_destroy(world);
}

// At the end of a step of any duration, the body has the target pose and zero velocity.
static void targets_are_reached(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body bodies[3];
	for (int k = 0; k < 3; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_KINEMATIC, 3.0f * (float)k, 0.0f);
	static const struct
	{
		float dt;
		int substeps;
	} steps[] = {{STEP, 4}, {0.1f, 1}, {1.0f / 240.0f, 2}, {1e-9f, 1}, {1.0f, 64}};
	for (int s = 0; s < 5; ++s)
	{
		float x = 0.1f * (float)s;
		scree_pose poses[3] = {pose_at(x, 0.3f, 0.1f), pose_at(3.0f + x, -x, -3.0f * x),
		                       pose_at(90000.0f, 0.37f, 3.1f)};
		OK(scree_bodies_set_targets(world, bodies, poses, 3));
		for (int k = 0; k < 3; ++k)
			expect_velocity(world, bodies[k], 0, 0, 0);
		OK(scree_world_step(world, steps[s].dt, steps[s].substeps));
		for (int k = 0; k < 3; ++k)
		{
			expect_pose(world, bodies[k], poses[k]);
			expect_velocity(world, bodies[k], 0, 0, 0);
		}
	}
	scree_pose last = pose_of(world, bodies[0]);
	run_steps(world, 3);
	expect_pose(world, bodies[0], last);
	scree_world_destroy(world);
}

// A kinematic platform with target poses carries a crate, and pushes a crate in front of it. Contacts use the velocity
// (target - pose) / dt.
static void targets_carry_and_push(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_KINEMATIC;
	def.attribute = box_attribute(world, 4.0f, 0.5f);
	scree_body platform = create_body(world, &def);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	run_steps(world, 30);
	float start = pose_of(world, crate).position.x;
	for (int k = 1; k <= 60; ++k)
	{
		// from rest to 2 m/s in 0.5 s, 4 m/s^2; a friction of 0.6 allows 6 m/s^2
		float t = (float)k * STEP, x = t < 0.5f ? 2.0f * t * t : 0.5f + 2.0f * (t - 0.5f);
		OK(scree_body_set_target(world, platform, pose_at(x, 0.0f, 0.0f)));
		run_steps(world, 1);
	}
	NEAR(pose_of(world, platform).position.x, 1.5, 1e-6);
	NEAR(pose_of(world, crate).position.x - start, 1.5, 0.02);
	NEAR(velocity_of(world, crate).linear.x, 2.0, 0.02);
	scree_world_destroy(world);

	world = open_test_world(0.0f);
	platform = add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 0.0f);
	crate = add_crate(world, SCREE_BODY_DYNAMIC, 1.2f, 0.0f);
	OK(scree_body_set_target(world, platform, pose_at(0.5f, 0.0f, 0.0f)));
	run_steps(world, 1);
	NEAR(velocity_of(world, crate).linear.x, 0.5 / STEP, 0.5);
	scree_world_destroy(world);
}

// The shorter way from 175 to -175 degrees is 10 degrees counter-clockwise, so the right end of a beam rises.
static void targets_turn_the_shorter_way(void** state)
{
	(void)state;
	for (int direction = -1; direction <= 1; direction += 2)
	{
		scree_world* world = open_test_world(0.0f);
		scree_body_def def = scree_body_def_default();
		def.type = SCREE_BODY_KINEMATIC;
		def.attribute = box_attribute(world, 4.0f, 0.1f);
		def.pose = pose_at(0.0f, 0.0f, (float)direction * 3.05432619f);
		scree_body beam = create_body(world, &def);
		scree_body above = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f, (float)direction * 0.5f);
		OK(scree_body_set_target(world, beam, pose_at(0.0f, 0.0f, (float)direction * -3.05432619f)));
		run_steps(world, 1);
		assert_true((float)direction * velocity_of(world, above).linear.y > 1.0f);
		scree_world_destroy(world);
	}
}

static void targets_wait_and_are_dropped(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 0.0f);
	scree_pose home = pose_of(world, body), there = pose_at(1.0f, 2.0f, 0.5f), later = pose_at(-1.0f, 0.0f, 0.0f);

	// a later target replaces an earlier one, and a step with dt 0 does not use the target
	uint64_t before = hash_of(world);
	OK(scree_body_set_target(world, body, there));
	uint64_t waiting = hash_of(world);
	assert_true(waiting != before);
	OK(scree_body_set_target(world, body, later));
	assert_true(hash_of(world) != waiting);
	update_contacts(world);
	expect_pose(world, body, home);
	run_steps(world, 1);
	expect_pose(world, body, later);

	// a pose set after the target does not change the target
	OK(scree_body_set_target(world, body, there));
	OK(scree_body_set_pose(world, body, home));
	run_steps(world, 1);
	expect_pose(world, body, there);

	// a velocity set after the target replaces it, also if only the linear or only the angular velocity is set
	for (int k = 0; k < 3; ++k)
	{
		OK(scree_body_set_pose(world, body, home));
		OK(scree_body_set_target(world, body, there));
		if (k == 0)
			throw_body(world, body, 0, 0, 0);
		else if (k == 1)
			OK(scree_body_set_linear_velocity(world, body, (scree_vec){0, 0}));
		else
			OK(scree_body_set_angular_velocity(world, body, 0));
		run_steps(world, 1);
		expect_pose(world, body, home);
	}
	OK(scree_body_set_target(world, body, there));
	OK(scree_body_set_type(world, body, SCREE_BODY_STATIC));
	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	run_steps(world, 1);
	expect_pose(world, body, home);

	// locked coordinates do not change
	OK(scree_body_set_locks(world, body, SCREE_LOCK_X | SCREE_LOCK_ROTATION));
	OK(scree_body_set_target(world, body, there));
	run_steps(world, 1);
	expect_pose(world, body, pose_at(0.0f, 2.0f, 0.0f));
	OK(scree_body_set_locks(world, body, 0));

	// a disabled body keeps its target and reaches it once it is enabled
	OK(scree_body_set_target(world, body, home));
	OK(scree_body_set_enabled(world, body, false));
	run_steps(world, 3);
	expect_pose(world, body, pose_at(0.0f, 2.0f, 0.0f));
	OK(scree_body_set_enabled(world, body, true));
	run_steps(world, 1);
	expect_pose(world, body, home);

	// destroying a body does not change the targets of others
	scree_body others[3];
	scree_pose poses[3];
	for (int k = 0; k < 3; ++k)
	{
		others[k] = add_crate(world, SCREE_BODY_KINEMATIC, 10.0f, 5.0f * (float)k);
		poses[k] = pose_at(11.0f, 5.0f * (float)k, 0.0f);
	}
	OK(scree_bodies_set_targets(world, others, poses, 3));
	OK(scree_body_destroy(world, others[0]));
	assert_int_equal(scree_body_set_target(world, others[0], home), SCREE_ERROR_STALE);
	others[0] = add_crate(world, SCREE_BODY_KINEMATIC, 20.0f, 0.0f);
	run_steps(world, 1);
	expect_pose(world, others[0], pose_at(20.0f, 0.0f, 0.0f));
	expect_pose(world, others[1], poses[1]);
	expect_pose(world, others[2], poses[2]);
	scree_world_destroy(world);
}

// A refused step changes nothing and keeps the targets.
static void refused_steps_keep_targets(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = test_device;
	def.contact_limit = 10;
	scree_world* world = create_world(&def);
	scree_body body = add_crate(world, SCREE_BODY_KINEMATIC, 50.0f, 0.0f), crowd[6];
	for (int k = 0; k < 6; ++k)
		crowd[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.1f * (float)k);
	scree_pose there = pose_at(51.0f, 1.0f, 1.0f);
	OK(scree_body_set_target(world, body, there));
	uint64_t before = hash_of(world);
	for (int k = 0; k < 2; ++k)
	{
		assert_int_equal(scree_world_step(world, k ? 0.0f : STEP, 4), SCREE_ERROR_CONTACT_LIMIT);
		assert_true(hash_of(world) == before);
		expect_velocity(world, body, 0, 0, 0);
	}
	OK(scree_bodies_destroy(world, crowd, 3));
	run_steps(world, 1);
	expect_pose(world, body, there);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(velocities_are_set_apart),     cmocka_unit_test(targets_are_reached),
	    cmocka_unit_test(targets_carry_and_push),       cmocka_unit_test(targets_turn_the_shorter_way),
	    cmocka_unit_test(targets_wait_and_are_dropped), cmocka_unit_test(refused_steps_keep_targets),
	};
	return RUN_ON_DEVICES(tests);
}
