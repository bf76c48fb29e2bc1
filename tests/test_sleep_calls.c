// SPDX-License-Identifier: MIT
// test_sleep_calls.c -- checks the calls that wake bodies and put them to sleep, and the settings of sleep.
#include "support/make_sleepers.h"

static const bool no[STACK] = {false}, yes[STACK] = {true, true, true, true};

// A call for one body acts on its island, even on one that moves. Other islands stay as they are.
static void islands_sleep_and_wake_as_a_whole(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK], other[STACK];
	add_stack(world, 0.0f, bodies);
	add_stack(world, 10.0f, other);
	run_steps(world, 5);
	OK(scree_body_set_awake(world, bodies[2], false));
	expect_awake(world, bodies, STACK, true); // sleep begins in the next step with dt above 0
	update_contacts(world);
	expect_awake(world, bodies, STACK, true);
	run_steps(world, 1);
	expect_awake(world, bodies, STACK, false);
	expect_awake(world, other, STACK, true);
	for (int k = 0; k < STACK; ++k)
		expect_velocity(world, bodies[k], 0, 0, 0);
	run_as_before(world, bodies, STACK, 20, false);

	OK(scree_body_set_awake(world, bodies[1], true));
	expect_awake(world, bodies, STACK, true);
	assert_int_equal(counters_of(world).asleep_bodies, 0);
	run_as_before(world, bodies, STACK, REST_STEPS - 1, true);
	run_to_sleep(world, bodies, STACK);
	run_to_sleep(world, other, STACK);

	// the later of two calls for a body counts
	OK(scree_body_set_awake(world, bodies[0], true));
	OK(scree_bodies_set_awake(world, bodies, no, STACK));
	run_steps(world, 1);
	expect_awake(world, bodies, STACK, false);
	OK(scree_bodies_set_awake(world, bodies, no, STACK));
	OK(scree_bodies_set_awake(world, bodies, yes, STACK));
	run_steps(world, 1);
	expect_awake(world, bodies, STACK, true);
	expect_awake(world, other, STACK, false);
	close_sleepers(world);
}

static void boxes_and_worlds_sleep_and_wake(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body left[STACK], right[STACK];
	add_stack(world, -5.0f, left);
	add_stack(world, 5.0f, right);
	scree_body falling = add_disc(world, 0.5f, 0.0f, 40.0f);
	run_steps(world, 5);
	OK(scree_world_set_box_awake(world, (scree_box){{-6.0f, 0.2f}, {-4.0f, 0.4f}}, false));
	run_steps(world, 1);
	expect_awake(world, left, STACK, false);
	expect_awake(world, right, STACK, true);
	OK(scree_world_set_awake(world, false));
	run_steps(world, 1);
	expect_awake(world, right, STACK, false);
	assert_false(is_awake(world, falling));
	expect_velocity(world, falling, 0, 0, 0);
	assert_int_equal(counters_of(world).asleep_bodies, 2 * STACK + 1);
	scree_pose pose = pose_of(world, falling);
	run_steps(world, 30);
	expect_pose(world, falling, pose);
	OK(scree_world_set_box_awake(world, (scree_box){{4.0f, 0.2f}, {6.0f, 0.4f}}, true));
	expect_awake(world, right, STACK, true);
	expect_awake(world, left, STACK, false);
	OK(scree_world_set_awake(world, true));
	expect_awake(world, left, STACK, true);
	run_steps(world, 1);
	NEAR(velocity_of(world, falling).linear.y, -G * STEP, 1e-6);
	close_sleepers(world);
}

static void bodies_that_cannot_move_do_not_sleep(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[3] = {add_crate(world, SCREE_BODY_STATIC, -5.0f, 0.5f),
	                        add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 0.5f),
	                        add_crate(world, SCREE_BODY_DYNAMIC, 5.0f, 0.5f)};
	OK(scree_body_set_enabled(world, bodies[2], false));
	OK(scree_bodies_set_awake(world, bodies, no, 3));
	OK(scree_world_set_awake(world, false));
	run_as_before(world, bodies, 3, 50, true);
	assert_int_equal(counters_of(world).asleep_bodies, 0);
	close_sleepers(world);
}

static void bodies_stay_awake(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	bool stays = false;
	add_stack(world, 0.0f, bodies);
	OK(scree_body_set_stays_awake(world, bodies[2], true));
	OK(scree_body_get_stays_awake(world, bodies[2], &stays));
	assert_true(stays);
	run_as_before(world, bodies, STACK, 100, true);
	OK(scree_bodies_set_awake(world, bodies, no, STACK));
	run_as_before(world, bodies, STACK, 3, true);
	OK(scree_body_set_stays_awake(world, bodies[2], false));
	run_to_sleep(world, bodies, STACK);

	// the setting wakes the body
	OK(scree_body_set_stays_awake(world, bodies[0], false));
	run_as_before(world, bodies, STACK, 2, false);
	OK(scree_body_set_stays_awake(world, bodies[0], true));
	run_as_before(world, bodies, STACK, 60, true);
	close_sleepers(world);
}

// Without gravity a disc drifts at 1 m/s: it is at rest if its threshold is higher.
static void thresholds(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(0.0f);
	scree_body_def def = body_def(SCREE_BODY_DYNAMIC, shape_attribute(world, circle_shape(0.5f)), 0.0f, 0.0f);
	scree_body bodies[3];
	for (int k = 0; k < 3; ++k)
	{
		def.pose.position.y = 5.0f * (float)k;
		def.velocity.linear.x = 1.0f;
		def.sleep_threshold = k == 0 ? 1.01f : k == 1 ? 0.99f : 0.0f;
		bodies[k] = create_body(world, &def);
	}
	run_as_before(world, bodies, 3, REST_STEPS - 1, true);
	run_steps(world, MOST_STEPS - REST_STEPS + 1);
	expect_awake(world, bodies, 1, false);
	expect_awake(world, bodies + 1, 2, true);
	expect_velocity(world, bodies[0], 0, 0, 0);
	NEAR(pose_of(world, bodies[0]).position.x, 0.5, 10 * STEP);

	// a change of the threshold wakes nothing
	float threshold;
	OK(scree_body_set_sleep_threshold(world, bodies[0], 0.5f));
	OK(scree_body_get_sleep_threshold(world, bodies[0], &threshold));
	assert_true(threshold == 0.5f);
	run_as_before(world, bodies, 1, 3, false);
	OK(scree_body_set_sleep_threshold(world, bodies[1], 2.0f));
	run_steps(world, MOST_STEPS);
	assert_true(!is_awake(world, bodies[1]) && is_awake(world, bodies[2]));

	// the threshold of the world applies to bodies that have none
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	assert_true(tuning.sleep && tuning.sleep_threshold == 0.05f);
	tuning.sleep_threshold = 1.5f;
	OK(scree_world_set_tuning(world, &tuning));
	expect_awake(world, bodies, 3, true); // as every change of the parameters, it wakes the world
	run_to_sleep(world, bodies, 3);
	close_sleepers(world);
}

static void sleep_is_switched(void** state)
{
	(void)state;
	scree_world* world = open_sleepers(-10.0f);
	scree_body bodies[STACK];
	scree_tuning tuning;
	add_stack(world, 0.0f, bodies);
	run_to_sleep(world, bodies, STACK);
	OK(scree_world_get_tuning(world, &tuning));
	tuning.sleep = false;
	OK(scree_world_set_tuning(world, &tuning));
	expect_awake(world, bodies, STACK, true);
	OK(scree_bodies_set_awake(world, bodies, no, STACK));
	OK(scree_world_set_awake(world, false));
	run_as_before(world, bodies, STACK, 100, true);
	assert_int_equal(counters_of(world).asleep_bodies, 0);
	assert_true(counters_of(world).colors > 0); // the contacts are solved again
	tuning.sleep = true;
	OK(scree_world_set_tuning(world, &tuning));
	run_to_sleep(world, bodies, STACK);
	close_sleepers(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(islands_sleep_and_wake_as_a_whole),
	    cmocka_unit_test(boxes_and_worlds_sleep_and_wake),
	    cmocka_unit_test(bodies_that_cannot_move_do_not_sleep),
	    cmocka_unit_test(bodies_stay_awake),
	    cmocka_unit_test(thresholds),
	    cmocka_unit_test(sleep_is_switched),
	};
	return RUN_SLEEPERS(tests);
}
