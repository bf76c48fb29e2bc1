// SPDX-License-Identifier: MIT
// test_interpolated.c -- checks poses between the last two steps, on the CPU and on OpenCL.
//
// Formula: p(alpha) = p0 + alpha (p1 - p0) for the center of mass, angle(alpha) = angle0 + alpha w dt.
#include "support/make_sleepers.h"
#include "support/second_device.h"
#include "support/snapshots.h"
#include <math.h>

#define MOST 40

// Reads the poses at a fraction of the last step, and checks their handles and number.
static int read_at(scree_world* world, float alpha, scree_pose poses[MOST])
{
	scree_body listed[MOST], bodies[MOST];
	int count, expected;
	memset(poses, 0, MOST * sizeof *poses);
	OK(scree_world_get_interpolated(world, alpha, listed, poses, MOST, &count));
	OK(scree_world_get_bodies(world, bodies, MOST, &expected));
	assert_int_equal(count, expected);
	assert_memory_equal(listed, bodies, (size_t)count * sizeof *bodies);
	return count;
}

static scree_pose body_at(scree_world* world, float alpha, scree_body body)
{
	scree_body bodies[MOST];
	scree_pose poses[MOST];
	int count;
	OK(scree_world_get_interpolated(world, alpha, bodies, poses, MOST, &count));
	for (int k = 0; k < count; ++k)
		if (scree_body_equals(bodies[k], body))
			return poses[k];
	fail_msg("no body %u", body.index);
	return poses[0];
}

static void expect_stands(scree_world* world, scree_body body)
{
	scree_pose now = pose_of(world, body);
	for (int k = 0; k <= 2; ++k)
	{
		scree_pose pose = body_at(world, 0.5f * (float)k, body);
		assert_memory_equal(&pose, &now, sizeof pose);
	}
}

// Returns the angle of a body at a fraction of the step, rad.
static double turned(scree_world* world, float alpha, scree_body body)
{
	scree_rot rotation = body_at(world, alpha, body).rotation;
	NEAR(rotation.c * rotation.c + rotation.s * rotation.s, 1.0, 3e-7);
	return atan2(rotation.s, rotation.c);
}

// The fraction 0 has the bits of the poses before the step, and 1 those after it.
static void ends_are_exact(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_pose before[MOST], after[MOST], found[MOST];
	add_floor(world);
	for (int k = 0; k < 30; ++k)
		throw_body(world, add_crate(world, SCREE_BODY_DYNAMIC, 1.3f * (float)(k % 6), 1.0f + (float)(k / 6)), (float)k,
		           -60.0f, 2.0f * (float)k);
	for (int step = 0; step < 60; ++step)
	{
		int count = read_at(world, 1.0f, before);
		run_steps(world, 1);
		assert_int_equal(read_at(world, 1.0f, after), count);
		for (int k = 1; k < count; ++k)
		{
			scree_body bodies[MOST];
			OK(scree_world_get_bodies(world, bodies, MOST, &count));
			expect_pose(world, bodies[k], after[k]);
		}
		read_at(world, 0.0f, found);
		assert_memory_equal(found, before, sizeof found);
	}
	scree_world_destroy(world);
}

// A body off its center of mass flies and turns evenly.
static void motion_is_even(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	static const scree_vec corners[] = {{0.0f, 0.0f}, {2.0f, 0.0f}, {2.0f, 1.0f}, {0.0f, 1.0f}};
	scree_body plate = add_shape(world, SCREE_BODY_DYNAMIC, polygon_shape(corners, 4, 0.0f), 5.0f, 3.0f, 0.0f);
	throw_body(world, plate, 6.0f, -3.0f, 20.0f);
	run_steps(world, 1);
	for (int k = 0; k <= 10; ++k)
	{
		float alpha = 0.1f * (float)k;
		scree_pose pose = body_at(world, alpha, plate);
		NEAR(turned(world, alpha, plate), alpha * 20.0 / 60.0, 2e-6);
		NEAR(pose.position.x + pose.rotation.c * 1.0f - pose.rotation.s * 0.5f, 6.0 + alpha * 0.1, 2e-6);
		NEAR(pose.position.y + pose.rotation.s * 1.0f + pose.rotation.c * 0.5f, 3.5 - alpha * 0.05, 2e-6);
	}
	scree_world_destroy(world);
}

// A wheel that turns by up to half a turn in a step keeps its direction. w: rad/s; half a turn of a step is 60 pi.
static void wheels_keep_their_direction(void** state)
{
	(void)state;
	static const double spins[] = {3.0, 150.0, 180.0, 188.0, 400.0};
	for (int k = 0; k < 10; ++k)
	{
		scree_world* world = open_test_world(0.0f);
		double w = spins[k / 2], most = w < 60.0 * PI ? w : 60.0 * PI, sign = k % 2 ? -1.0 : 1.0;
		scree_body wheel = add_disc(world, 0.3f, 0.0f, 0.0f);
		throw_body(world, wheel, 0.0f, 0.0f, (float)(sign * w));
		for (int step = 0; step < 3; ++step)
		{
			OK(scree_body_set_pose(world, wheel, upright_at(0.0f, 0.0f)));
			run_steps(world, 1);
			NEAR(turned(world, 0.25f, wheel), sign * 0.25 * most / 60.0, 1e-4);
			NEAR(turned(world, 0.75f, wheel), sign * 0.75 * most / 60.0, 1e-4);
		}
		scree_world_destroy(world);
	}
}

static void what_does_not_move_stands(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body floor = add_floor(world), bodies[4], fresh;
	for (int k = 0; k < 4; ++k)
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f * (float)k, 20.0f);
	expect_stands(world, bodies[0]); // before the first step
	run_steps(world, 20);
	expect_stands(world, floor);
	assert_true(body_at(world, 0.0f, bodies[0]).position.y > position_of(world, bodies[0]).y + 0.04f);

	OK(scree_body_set_pose(world, bodies[0], upright_at(-9.0f, 30.0f)));
	OK(scree_body_set_enabled(world, bodies[1], false));
	OK(scree_body_set_type(world, bodies[2], SCREE_BODY_STATIC));
	fresh = add_crate(world, SCREE_BODY_DYNAMIC, 20.0f, 5.0f);
	expect_stands(world, bodies[0]);
	expect_stands(world, bodies[1]);
	expect_stands(world, bodies[2]);
	expect_stands(world, fresh);
	assert_true(body_at(world, 0.0f, bodies[3]).position.y > position_of(world, bodies[3]).y + 0.04f);

	// a teleport between two steps is no motion of the second one
	run_steps(world, 1);
	NEAR(body_at(world, 0.0f, bodies[0]).position.y, 30.0, 1e-6);
	expect_stands(world, bodies[1]);

	// a new body in the slot of a destroyed one
	run_steps(world, 20);
	OK(scree_body_destroy(world, fresh));
	expect_stands(world, add_crate(world, SCREE_BODY_DYNAMIC, 20.0f, 5.0f));
	scree_world_destroy(world);
}

// A collidable that is added to a moving body moves its center of mass, not its path.
static void new_centers_do_not_jump(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 2.0f);
	throw_body(world, body, 6.0f, 0.0f, 3.0f);
	run_steps(world, 1);
	scree_pose before[2];
	for (int k = 0; k < 2; ++k)
		before[k] = body_at(world, 0.5f * (float)k, body);
	scree_collidable_def def = scree_collidable_def_default();
	def.body = body;
	def.attribute = box_attribute(world, 0.5f, 0.5f);
	def.pose = upright_at(1.0f, 1.0f);
	create_collidable(world, &def);
	scree_pose pose = body_at(world, 0.0f, body);
	NEAR(pose.position.x, before[0].position.x, 1e-6);
	NEAR(pose.position.y, before[0].position.y, 1e-6);
	pose = body_at(world, 0.5f, body);
	NEAR(pose.position.x, before[1].position.x, 1e-3); // the center of mass moves straight, and it is another one
	scree_world_destroy(world);
}

static void targets_are_reached(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body lift = add_crate(world, SCREE_BODY_KINEMATIC, 0.0f, 0.0f);
	OK(scree_body_set_target(world, lift, pose_at(0.2f, 0.1f, 0.4f)));
	run_steps(world, 1);
	scree_pose pose = body_at(world, 0.5f, lift);
	NEAR(pose.position.x, 0.1, 1e-6);
	NEAR(pose.position.y, 0.05, 1e-6);
	NEAR(turned(world, 0.5f, lift), 0.2, 1e-6);
	run_steps(world, 1);
	expect_stands(world, lift);
	scree_world_destroy(world);
}

// A step of 0 s has no poses of its own, so a pause does not move the picture.
static void pauses_keep_the_picture(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 2.0f);
	run_steps(world, 10);
	scree_pose before = body_at(world, 0.3f, body);
	for (int k = 0; k < 3; ++k)
		update_contacts(world);
	scree_pose after = body_at(world, 0.3f, body);
	assert_memory_equal(&before, &after, sizeof after);
	scree_world_destroy(world);
}

// Worlds that sleep skip groups of bodies, and whole steps; a lift stands in the steps after its target.
static void sleepers_stand(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = test_device;
	def.sleep = true;
	scree_world* world = create_world(&def);
	scree_body bodies[STACK], lift = add_crate(world, SCREE_BODY_KINEMATIC, 20.0f, 0.0f);
	add_floor(world);
	add_stack(world, 0.0f, bodies);
	run_to_sleep(world, bodies, STACK);
	OK(scree_body_set_target(world, lift, upright_at(20.0f, 0.1f)));
	run_steps(world, 1);
	NEAR(body_at(world, 0.5f, lift).position.y, 0.05, 1e-6);
	for (int k = 0; k < 40; ++k)
	{
		run_steps(world, 1);
		expect_stands(world, lift);
		expect_stands(world, bodies[STACK - 1]);
	}

	// the user puts moving bodies to sleep, and pauses
	throw_body(world, bodies[3], 5.0f, 5.0f, 5.0f);
	run_steps(world, 1);
	OK(scree_body_set_awake(world, bodies[3], false));
	for (int k = 0; k < 40; ++k)
		update_contacts(world);
	for (int k = 0; k < 40; ++k)
	{
		run_steps(world, 1);
		if (!is_awake(world, bodies[3]))
			expect_stands(world, bodies[3]);
	}
	scree_world_destroy(world);
}

// After a load, a restore and a move bodies stand until the next step.
static void worlds_that_jump_go_on(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 50.0f);
	run_steps(world, 10);
	Saved saved = save(world);
	OK(scree_world_save(world, 0));
	for (int k = 0; k < 4; ++k)
	{
		run_steps(world, 5);
		scree_pose before = pose_of(world, body);
		run_steps(world, 1);
		scree_pose found = body_at(world, 0.0f, body);
		assert_memory_equal(&found, &before, sizeof found);
		if (k == 0)
			OK(scree_world_load(world, 0));
		else if (k == 1)
			OK(scree_world_restore(world, saved.bytes, saved.size));
		else if (k == 2 && second_device[0])
			OK(scree_world_move(world, strcmp(test_device, "cpu") == 0 ? second_device : "cpu"));
		else
			continue;
		expect_stands(world, body);
	}
	free(saved.bytes);
	scree_world_destroy(world);
}

// Reading changes neither snapshots nor later steps.
static void reading_changes_nothing(void** state)
{
	(void)state;
	scree_world *read = open_pile(test_device, false), *other = open_pile(test_device, false);
	scree_pose poses[MOST];
	scree_render_row rows[MOST];
	int count;
	for (int step = 0; step < 30; ++step)
	{
		Saved before = save(read);
		for (int k = 0; k <= 4; ++k)
		{
			OK(scree_world_get_interpolated(read, 0.25f * (float)k, NULL, poses, MOST, &count));
			OK(scree_world_get_interpolated_rows(read, 0.25f * (float)k, rows, MOST, &count));
		}
		assert_snapshot(read, before);
		free(before.bytes);
		run_steps(read, 1);
		run_steps(other, 1);
		assert_true(hash_of(read) == hash_of(other));
	}
	scree_world_destroy(read);
	scree_world_destroy(other);
}

// Rows have the poses of the bodies, those of the fraction 1 the bits of the current rows; a part without a body stands.
static void rows_follow_bodies(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_collidable_def wall = scree_collidable_def_default();
	wall.attribute = box_attribute(world, 1.0f, 1.0f);
	wall.pose = upright_at(-20.0f, 0.0f);
	create_collidable(world, &wall);
	scree_body bodies[8];
	for (int k = 0; k < 8; ++k)
		throw_body(world, bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f * (float)k, 5.0f), 9.0f, (float)k,
		           4.0f);
	run_steps(world, 5);
	scree_render_row rows[MOST], now[MOST];
	int count, expected;
	OK(scree_world_get_render_rows(world, now, MOST, &expected));
	OK(scree_world_get_interpolated_rows(world, 1.0f, rows, MOST, &count));
	assert_int_equal(count, expected);
	assert_memory_equal(rows, now, (size_t)count * sizeof *rows);
	OK(scree_world_get_interpolated_rows(world, 0.6f, rows, MOST, &count));
	assert_memory_equal(rows, now, sizeof *rows);
	for (int k = 0; k < 8; ++k)
	{
		scree_pose pose = body_at(world, 0.6f, bodies[k]);
		assert_int_equal(rows[k + 1].body, bodies[k].index);
		assert_memory_equal(&rows[k + 1].pose, &pose, sizeof pose);
	}
	scree_world_destroy(world);
}

static void refuse(scree_status status, const char* words)
{
	assert_int_equal(status, SCREE_ERROR_INVALID);
	if (!strstr(scree_error(), words))
		fail_msg("\"%s\" does not say \"%s\"", scree_error(), words);
}

static void bad_arguments_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_crate(world, SCREE_BODY_DYNAMIC, 1.0f, 2.0f);
	run_steps(world, 2);
	static const float bad[] = {-0.001f, 1.001f, NAN, INFINITY, -INFINITY};
	scree_pose poses[2], small;
	scree_render_row rows[2];
	int count = -7;
	for (int k = 0; k < 5; ++k)
	{
		refuse(scree_world_get_interpolated(world, bad[k], NULL, poses, 2, &count),
		       "scree_world_get_interpolated: alpha is ");
		refuse(scree_world_get_interpolated_rows(world, bad[k], rows, 2, &count), "_interpolated_rows: alpha is ");
		refuse(scree_world_write_interpolated_rows(world, bad[k], &count), "_interpolated_rows: alpha is ");
	}
	refuse(scree_world_get_interpolated(world, 0.5f, NULL, poses, -1, &count), "capacity is -1");
	refuse(scree_world_get_interpolated(world, 0.5f, NULL, NULL, 1, &count), "poses is null");
	refuse(scree_world_get_interpolated(world, 0.5f, NULL, poses, 1, NULL), "count is null");
	refuse(scree_world_get_interpolated(NULL, 0.5f, NULL, poses, 1, &count), "world is null");
	refuse(scree_world_get_interpolated_rows(world, 0.5f, NULL, 1, &count), "rows is null");
	refuse(scree_world_write_interpolated_rows(world, 0.5f, &count), "nothing is shared");
	assert_int_equal(count, -7);
	OK(scree_world_get_interpolated(world, 0.5f, NULL, NULL, 0, &count));
	assert_int_equal(count, 1);

	// the smallest fraction, a denormal, is as 0; -0 is 0
	OK(scree_world_get_interpolated(world, 0.0f, NULL, poses, 2, &count));
	OK(scree_world_get_interpolated(world, 1e-45f, NULL, &small, 1, &count));
	assert_memory_equal(&small, poses, sizeof small);
	OK(scree_world_get_interpolated(world, -0.0f, NULL, &small, 1, &count));
	assert_memory_equal(&small, poses, sizeof small);
	scree_world_destroy(world);
}

int main(void)
{
	find_second_device(NULL);
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(ends_are_exact),
	    cmocka_unit_test(motion_is_even),
	    cmocka_unit_test(wheels_keep_their_direction),
	    cmocka_unit_test(what_does_not_move_stands),
	    cmocka_unit_test(new_centers_do_not_jump),
	    cmocka_unit_test(targets_are_reached),
	    cmocka_unit_test(pauses_keep_the_picture),
	    cmocka_unit_test(sleepers_stand),
	    cmocka_unit_test(worlds_that_jump_go_on),
	    cmocka_unit_test(reading_changes_nothing),
	    cmocka_unit_test(rows_follow_bodies),
	    cmocka_unit_test(bad_arguments_are_refused),
	};
	return RUN_ON_DEVICES(tests);
}
