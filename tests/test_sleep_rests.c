// SPDX-License-Identifier: MIT
// test_sleep_rests.c -- checks which bodies are at rest: those on belts, on moving platforms, in swings and in bounces
// are not.
#include "support/make_joints.h"
#include "support/make_sleepers.h"
#include <math.h>

// A ball with restitution 1 falls from 1 m and keeps bouncing, even though it is slow near the top.
static void a_bouncing_ball_does_not_sleep(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body ball =
	    add_body(world, SCREE_BODY_DYNAMIC, add_surface(world, circle_shape(0.5f), 0.6f, 1.0f), 0.0f, 1.5f, 0.0f);
	float highest = 0.0f;
	for (int k = 0; k < 600; ++k)
	{
		run_steps(world, 1);
		assert_true(is_awake(world, ball));
		float y = pose_of(world, ball).position.y;
		highest = k >= 480 && y > highest ? y : highest;
	}
	assert_true(highest > 1.2f); // within the last 2 s it still rose
	close_sleepers(world);
}

// Opens a world with a belt of 120 m, whose surface is at y = 1.5 and moves at this speed, m/s.
static scree_world* open_belt(float speed)
{
	scree_world* world = open_sleepers(-10.0f);
	scree_attribute_def def = surface_of(box_shape(60.0f, 0.5f));
	def.tangent_speed = speed;
	add_body(world, SCREE_BODY_STATIC, add_attribute(world, &def), 0.0f, 1.0f, 0.0f);
	return world;
}

static void a_box_on_a_belt_does_not_sleep(void** state)
{
	(void)state;
	scree_world* world = open_belt(1.0f);
	scree_body box = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 2.0f);
	run_as_before(world, &box, 1, 600, true);
	NEAR(velocity_of(world, box).linear.x, 1.0, 0.01);
	NEAR(pose_of(world, box).position.x, 10.0, 0.3);
	close_sleepers(world);
}

// A belt of 0.02 m/s is slower than the threshold, but carries a box for ever. A box that a wall holds on it sleeps.
static void slow_belts_keep_boxes_awake(void** state)
{
	(void)state;
	scree_world* world = open_belt(0.02f);
	scree_body box = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 2.0f),
	           held = add_crate(world, SCREE_BODY_DYNAMIC, 9.0f, 2.0f);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 0.5f, 10.0f, 2.0f);
	run_as_before(world, &box, 1, 600, true);
	NEAR(pose_of(world, box).position.x, 0.2, 0.02);
	assert_false(is_awake(world, held));
	close_sleepers(world);
}

// A platform of 0.01 m/s is slower than the threshold, but a box on it sleeps only after the platform has stopped.
static void platforms_keep_boxes_awake(void** state)
{
	(void)state;
	for (int across = 0; across < 2; ++across)
	{
		scree_world* world = open_sleepers(-10.0f);
		scree_body platform = add_box(world, SCREE_BODY_KINEMATIC, 3.0f, 0.5f, 0.0f, 2.0f);
		scree_body box = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 3.0f),
		           still = add_crate(world, SCREE_BODY_DYNAMIC, 9.0f, 0.5f);
		scree_vec slow = across ? (scree_vec){0.01f, 0.0f} : (scree_vec){0.0f, 0.01f};
		OK(scree_body_set_linear_velocity(world, platform, slow));
		run_as_before(world, &box, 1, 300, true);
		assert_false(is_awake(world, still));
		scree_vec at = pose_of(world, box).position;
		NEAR(at.x, across ? 0.05 : 0.0, 0.002);
		NEAR(at.y, across ? 3.0 : 3.05, 0.01);
		OK(scree_body_set_linear_velocity(world, platform, (scree_vec){0, 0}));
		run_steps(world, MOST_STEPS + 5);
		assert_false(is_awake(world, box));
		close_sleepers(world);
	}
}

// A pendulum is slow at each end of its swing, but not for 0.5 s. A disc that turns in place moves as well.
static void motion_keeps_bodies_awake(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body weight = add_disc(world, 0.2f, 2.0f, 10.0f);
	join(world, SCREE_JOINT_REVOLUTE, NOBODY, weight, 0.0f, 10.0f);
	run_as_before(world, &weight, 1, 600, true);
	assert_true(pose_of(world, weight).position.y <= 10.0f);
	close_sleepers(world);

	world = open_sleepers(0.0f);
	scree_body discs[2] = {add_disc(world, 0.5f, 0.0f, 0.0f), add_disc(world, 0.5f, 5.0f, 0.0f)};
	throw_body(world, discs[0], 0.0f, 0.0f, 0.11f); // the rim moves at 0.055 m/s
	throw_body(world, discs[1], 0.0f, 0.0f, 0.09f);
	run_steps(world, MOST_STEPS + 1);
	assert_true(is_awake(world, discs[0]) && !is_awake(world, discs[1]));
	expect_velocity(world, discs[1], 0, 0, 0);
	run_as_before(world, discs, 1, 200, true);
	close_sleepers(world);
}

// The time of rest is counted in seconds, whatever the length of a step. A step of dt 0 counts nothing.
static void time_counts(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(0.0f);
	scree_body disc = add_disc(world, 0.5f, 0.0f, 0.0f);
	for (int k = 0; k < 100; ++k)
		update_contacts(world);
	assert_true(is_awake(world, disc));
	for (int k = 0; k < 8; ++k)
		OK(scree_world_step(world, 0.0625f, SUBSTEPS));
	for (int k = 0; k < 8 && is_awake(world, disc); ++k)
		OK(scree_world_step(world, 1e-3f, SUBSTEPS));
	assert_false(is_awake(world, disc));
	OK(scree_body_set_awake(world, disc, true));
	for (int k = 0; k < 400; ++k)
	{
		OK(scree_world_step(world, 1e-3f, SUBSTEPS));
		assert_true(is_awake(world, disc));
	}
	close_sleepers(world);
}

static int touching_of(scree_world* world)
{
	scree_counters counters;
	OK(scree_world_get_counters(world, &counters));
	return counters.touching;
}

// Contacts of small bodies begin at a distance of about g dt^2: 1.4 mm at 60 Hz, less than 1 mm in shorter steps. A step of another
// length ends the contact of a box of 4 mm that sleeps with a belt beside it, 1 mm away, also if the step would visit nothing there:
// the world has the hash of its clone, which visits all contacts.
static void lengths_of_steps_matter_at_rest(void** state)
{
	(void)state;
	static const float lengths[] = {0.0f, 1.0f / 60.0f, 1.0f / 240.0f, 1.0f / 60.0f};
	scree_world *world = open_sleepers(-10.0f), *clone;
	scree_attribute_def belt = surface_of(box_shape(0.1f, 0.1f));
	belt.tangent_speed = 1.0f;
	add_body(world, SCREE_BODY_STATIC, add_attribute(world, &belt), 0.103f, 0.1f, 0.0f);
	scree_body box = add_box(world, SCREE_BODY_DYNAMIC, 0.002f, 0.002f, 0.0f, 0.002f);
	scree_body mover =
	    add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 0.5f, 0.0f, 50.0f); // without it no step is taken at rest
	OK(scree_body_set_linear_velocity(world, mover, (scree_vec){1.0f, 0.0f}));
	run_to_sleep(world, &box, 1);
	run_steps(world, 60);
	assert_int_equal(touching_of(world), 2);
	for (int k = 0; k < 4; ++k)
	{
		OK(scree_world_clone(world, NULL, &clone));
		OK(scree_world_step(world, lengths[k], SUBSTEPS));
		OK(scree_world_step(clone, lengths[k], SUBSTEPS));
		assert_true(hash_of(world) == hash_of(clone));
		assert_int_equal(touching_of(world), 1);
		scree_world_destroy(clone);
	}
	close_sleepers(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_bouncing_ball_does_not_sleep),  cmocka_unit_test(a_box_on_a_belt_does_not_sleep),
	    cmocka_unit_test(slow_belts_keep_boxes_awake),     cmocka_unit_test(platforms_keep_boxes_awake),
	    cmocka_unit_test(motion_keeps_bodies_awake),       cmocka_unit_test(time_counts),
	    cmocka_unit_test(lengths_of_steps_matter_at_rest),
	};
	return RUN_SLEEPERS(tests);
}
