// SPDX-License-Identifier: MIT
// test_exclusions.c -- checks exclusions, pairs of bodies that never touch: setting and reading, beside joints, after a
// destruction, and in reused slots.
#include "support/make_joints.h"
#include <math.h>

static void exclude(scree_world* world, scree_body a, scree_body b, bool excluded)
{
	OK(scree_body_set_excluded(world, a, b, excluded));
}

static int excluded_of(scree_world* world, scree_body body)
{
	int count;
	OK(scree_body_get_excluded(world, body, NULL, 0, &count));
	return count;
}

// A box lies on another box. When the two boxes are excluded, the upper box falls through the lower one, and their
// touch ends once.
static void while_touching(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body low = add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, 0.0f, 0.5f),
	           high = add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, 0.0f, 1.5f);
	run_steps(world, 30);
	assert_int_equal(contacts_of(world), 2);
	uint64_t before = hash_of(world);
	exclude(world, high, low, true);
	assert_true(hash_of(world) != before);
	assert_true(scree_body_is_excluded(world, low, high) && scree_body_is_excluded(world, high, low));
	run_steps(world, 1);
	scree_events events = events_of(world);
	assert_int_equal(events.touches_ended_count, 1);
	run_steps(world, 60);
	NEAR(pose_of(world, high).position.y, 0.5, 0.01);
	// after the end of the exclusion the overlapping boxes push each other apart
	exclude(world, low, high, false);
	run_steps(world, 1);
	events = events_of(world);
	assert_int_equal(events.touches_began_count, 1);
	run_steps(world, 120);
	float apart = fmaxf(fabsf(pose_of(world, low).position.x - pose_of(world, high).position.x),
	                    fabsf(pose_of(world, low).position.y - pose_of(world, high).position.y));
	assert_true(apart > 0.9f);
	scree_world_destroy(world);
}

// An exclusion prevents contacts even after a joint between the bodies is destroyed. A joint prevents contacts even
// after an exclusion of its bodies has ended.
static void beside_joints(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body a = add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, 0.0f, 0.0f),
	           b = add_reporter(world, box_shape(0.5f, 0.5f), SCREE_REPORT_TOUCHES, 0.9f, 0.0f);
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_WELD);
	def.body_a = a;
	def.body_b = b;
	def.frame_a.position.x = 0.9f;
	scree_joint joint = add_joint(world, &def);
	exclude(world, a, b, true);
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 0);
	OK(scree_joint_destroy(world, joint));
	run_steps(world, 2);
	assert_int_equal(contacts_of(world), 0);
	joint = add_joint(world, &def);
	exclude(world, a, b, false);
	run_steps(world, 2);
	assert_int_equal(contacts_of(world), 0);
	OK(scree_joint_destroy(world, joint));
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 1);
	scree_world_destroy(world);
}

// A body in a reused slot has none of the exclusions of the destroyed body.
static void destroyed(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body low = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f),
	           high = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f);
	exclude(world, low, high, true);
	run_steps(world, 1);
	OK(scree_body_destroy(world, high));
	assert_int_equal(excluded_of(world, low), 0);
	scree_body again = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f);
	assert_int_equal(again.index, high.index);
	assert_true(!scree_body_is_excluded(world, low, again) && !scree_body_is_excluded(world, low, high));
	run_steps(world, 60);
	NEAR(pose_of(world, again).position.y, 1.5, 0.02);
	scree_world_destroy(world);
}

// A fast body passes through a wall if the two are excluded. Otherwise the wall stops it.
static void fast(void** state)
{
	(void)state;
	for (int excluded = 0; excluded < 2; ++excluded)
	{
		scree_world* world = open_test_world(0.0f);
		scree_body wall = add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f);
		scree_body bullet = add_crate(world, SCREE_BODY_DYNAMIC, -5.3f, 0.0f);
		exclude(world, wall, bullet, true);
		exclude(world, wall, bullet, excluded);
		OK(scree_body_set_linear_velocity(world, bullet, (scree_vec){200.0f, 0.0f}));
		run_steps(world, 20);
		assert_true(excluded ? pose_of(world, bullet).position.x > 50.0f : pose_of(world, bullet).position.x < 0.0f);
		scree_world_destroy(world);
	}
}

// Each of 60 bodies excludes all others. The test sets the exclusions in batches, reads them as lists, and moves the
// world to another device. Then it ends some of the exclusions.
static void crowd(void** state)
{
	(void)state;
	enum
	{
		BODIES = 60
	};
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body bodies[BODIES], a[BODIES * BODIES], b[BODIES * BODIES], others[BODIES];
	bool all[BODIES * BODIES];
	int pairs = 0, count;
	for (int k = 0; k < BODIES; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.02f * (float)k, 0.5f + 0.05f * (float)k);
	for (int i = 0; i < BODIES; ++i)
		for (int j = 0; j < i; ++j, ++pairs)
			a[pairs] = bodies[i], b[pairs] = bodies[j], all[pairs] = true;
	OK(scree_bodies_set_excluded(world, a, b, all, pairs));
	OK(scree_bodies_set_excluded(world, b, a, all, pairs)); // an exclusion that is set twice counts once
	run_steps(world, 120);
	assert_int_equal(contacts_of(world), BODIES);
	for (int k = 0; k < BODIES; ++k)
		NEAR(pose_of(world, bodies[k]).position.y, 0.5, 0.01);
	OK(scree_world_move(world, "cpu"));
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), BODIES);
	OK(scree_body_get_excluded(world, bodies[7], others, BODIES, &count));
	assert_int_equal(count, BODIES - 1);
	for (int k = 1; k < count; ++k)
		assert_true(others[k].index > others[k - 1].index);
	for (int k = 0; k < pairs; ++k)
		all[k] = k % 2;
	OK(scree_bodies_set_excluded(world, a, b, all, pairs));
	int left = 0;
	for (int k = 0; k < BODIES; ++k)
		left += excluded_of(world, bodies[k]);
	assert_int_equal(left, 2 * (pairs / 2));
	run_steps(world, 1);
	assert_true(contacts_of(world) > BODIES);
	OK(scree_bodies_destroy(world, bodies, BODIES / 2));
	run_steps(world, 1);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(while_touching), cmocka_unit_test(beside_joints), cmocka_unit_test(destroyed),
	    cmocka_unit_test(fast),           cmocka_unit_test(crowd),
	};
	return RUN_ON_DEVICES(tests);
}
