// SPDX-License-Identifier: MIT
// test_freeze.c -- checks that bodies with numbers that are not finite stop for a step and are logged, and that all
// other bodies continue. Also checks that no valid call makes such a body.
#include "support/log_lines.h"
#include "support/make_joints.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// Overwrites the velocity of a body directly in the pool.
static void poke_velocity(scree_world* world, scree_body body, float vx, float w)
{
	Backend* b = world->backend;
	BodyState row;
	OK(world_upload(world));
	OK(b->f->read(b, POOL_body, (int)body.index, 1, &row));
	row.vx = vx;
	row.w = w;
	OK(b->f->write(b, POOL_body, (int)body.index, 1, &row));
}

// Makes the state of one body not finite by a call of `hurt`. amid: true for a body that touches others, false for a
// body far from all others. Bodies that touch this body may freeze with it for one step. All other bodies move as
// before, and after that step the frozen bodies move again.
static void check_frozen(bool amid, void (*hurt)(scree_world* world, scree_body body))
{
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body row[8];
	for (int k = 0; k < 8; ++k)
		row[k] = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f * (float)k, 0.5f);
	scree_body above = add_crate(world, SCREE_BODY_DYNAMIC, 9.0f, 1.5f);
	scree_body falling = add_crate(world, SCREE_BODY_DYNAMIC, -20.0f, 1000.0f);
	run_steps(world, 20);
	assert_int_equal(counters_of(world).frozen_bodies, 0);

	scree_body victim = amid ? row[3] : falling;
	scree_vec before = position_of(world, victim);
	warning_count = 0;
	hurt(world, victim);
	run_steps(world, 1);
	scree_counters counters = counters_of(world);
	assert_in_range(counters.frozen_bodies, 1, amid ? 2 : 1);
	check_finite(world);
	scree_vec after = position_of(world, victim);
	assert_true(before.x == after.x && before.y == after.y);
	scree_velocity velocity = velocity_of(world, victim);
	assert_true(velocity.linear.x == 0.0f && velocity.linear.y == 0.0f && velocity.angular == 0.0f);

	// the next step reads the counters and logs a warning
	run_steps(world, 1);
	assert_int_equal(warning_count, 1);
	char name[32];
	snprintf(name, sizeof name, "body %u", victim.index);
	assert_non_null(strstr(last_warning, name));

	// all bodies continue to move
	run_steps(world, 119);
	assert_int_equal(warning_count, 1);
	assert_int_equal(counters_of(world).frozen_bodies, 0);
	check_finite(world);
	for (int k = 0; k < 8; ++k)
	{
		NEAR(position_of(world, row[k]).x, 3.0 * k, 0.01);
		NEAR(position_of(world, row[k]).y, 0.5, 0.01);
	}
	NEAR(position_of(world, above).y, 1.5, 0.01);
	double seconds = (amid ? 141.0 : 120.0) / 60.0;
	NEAR(velocity_of(world, falling).linear.y, -10.0 * seconds, 0.02);
	scree_world_destroy(world);
}

static void hurt_by_nan(scree_world* world, scree_body body) { poke_velocity(world, body, NAN, 0.0f); }
static void hurt_by_spin(scree_world* world, scree_body body) { poke_velocity(world, body, 0.0f, NAN); }

static void bodies_freeze(void** state)
{
	(void)state;
	for (int amid = 0; amid <= 1; ++amid)
	{
		check_frozen(amid, hurt_by_nan);
		check_frozen(amid, hurt_by_spin);
	}
}

// Each function push_by_... applies several valid forces, torques or impulses whose sum is beyond a float.
static void push_by_force(scree_world* world, scree_body body)
{
	OK(scree_body_apply_force(world, body, (scree_vec){FLT_MAX, 0.0f}));
	OK(scree_body_apply_force(world, body, (scree_vec){FLT_MAX, 0.0f}));
}

static void push_by_torque(scree_world* world, scree_body body)
{
	OK(scree_body_apply_torque(world, body, FLT_MAX));
	OK(scree_body_apply_torque(world, body, FLT_MAX));
	OK(scree_body_apply_force_at(world, body, (scree_vec){-FLT_MAX, FLT_MAX}, (scree_vec){1e4f, 1e4f}));
	OK(scree_body_apply_force_at(world, body, (scree_vec){FLT_MAX, FLT_MAX}, (scree_vec){1e4f, 1e4f}));
}

static void push_by_impulse(scree_world* world, scree_body body)
{
	OK(scree_body_apply_impulse_at(world, body, (scree_vec){FLT_MAX, 0.0f}, (scree_vec){0.0f, SCREE_MAX_COORDINATE}));
	OK(scree_body_apply_impulse_at(world, body, (scree_vec){FLT_MAX, FLT_MAX},
	                               (scree_vec){SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE}));
}

// Pushes a body, which may be disabled. Checks that the velocity that is read is finite. After the body is enabled,
// checks that it reaches the speed limit, or a spin of 100 rad/s, and does not exceed the speed limit.
static void check_most(void (*push)(scree_world* world, scree_body body), bool disabled)
{
	scree_world* world = open_world(0.0f);
	scree_attribute_def light = surface_of(box_shape(0.5f, 0.5f));
	light.density = 0.01f;
	scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &light), 0.0f, 0.0f, 0.0f);
	OK(scree_body_set_enabled(world, body, !disabled));
	warning_count = 0;
	push(world, body);
	scree_velocity velocity = velocity_of(world, body);
	assert_true(isfinite(velocity.linear.x) && isfinite(velocity.linear.y) && isfinite(velocity.angular));
	run_steps(world, 2);
	OK(scree_body_set_enabled(world, body, true));
	for (int step = 0; step < 3; ++step)
	{
		run_steps(world, 1);
		assert_int_equal(counters_of(world).frozen_bodies, 0);
		check_finite(world);
		velocity = velocity_of(world, body);
		assert_true(hypotf(velocity.linear.x, velocity.linear.y) < 400.1f);
	}
	if (push == push_by_impulse || !disabled) // forces on a disabled body are not stored
		assert_true(hypotf(velocity.linear.x, velocity.linear.y) > 399.0f || fabsf(velocity.angular) > 100.0f);
	assert_int_equal(warning_count, 0);
	scree_world_destroy(world);
}

static void sums_end_at_the_most(void** state)
{
	(void)state;
	for (int disabled = 0; disabled <= 1; ++disabled)
	{
		check_most(push_by_force, disabled);
		check_most(push_by_torque, disabled);
		check_most(push_by_impulse, disabled);
	}
}

// Beads of 2 mm are welded or hinged together at arms of 0.5 m. The inertia of a bead is 1/125,000 of m L^2, with the
// mass m of the bead and the arm L. The beads fall, and stay in a row.
static void beads_at_long_arms(scree_joint_type type)
{
	scree_world* world = open_world(-10.0f);
	scree_attribute bead = shape_attribute(world, circle_shape(0.002f));
	scree_body beads[15];
	for (int k = 0; k < 15; ++k)
	{
		beads[k] = add_body(world, SCREE_BODY_DYNAMIC, bead, 0.0f, (float)k, 0.0f);
		if (k > 0)
			join(world, type, beads[k - 1], beads[k], 0.0f, (float)k - 0.5f);
	}
	throw_body(world, beads[7], 1.0f, 0.0f, 0.0f);
	warning_count = 0;
	run_steps(world, 60);
	for (int k = 0; k < 15; ++k)
	{
		scree_velocity velocity = velocity_of(world, beads[k]);
		NEAR(velocity.linear.y, -10.0, 1.0);
		NEAR(velocity.linear.x, 0.0, 2.0);
		if (k > 0)
		{
			scree_vec a = position_of(world, beads[k - 1]), b = position_of(world, beads[k]);
			NEAR(hypotf(b.x - a.x, b.y - a.y), 1.0, 0.05);
		}
	}
	assert_int_equal(warning_count, 0);
	scree_world_destroy(world);
}

// A pendulum of 1 m swings from 60 degrees on the left to 60 degrees on the right. Its mass is 1 kg, with the smallest
// valid inertia, 1e-20 kg m^2. set_last: sets the mass after the joint is added, not before.
static void pendulum_without_inertia(bool set_last)
{
	scree_world* world = open_world(-10.0f);
	scree_body anchor = add_box(world, SCREE_BODY_STATIC, 0.1f, 0.1f, 0.0f, 0.0f);
	scree_body bob = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, -sinf(1.0471976f), -0.5f);
	scree_mass mass = {.mass = 1.0f, .inertia = 1.0e-20f}, read;
	if (!set_last)
		OK(scree_body_set_mass(world, bob, mass));
	join(world, SCREE_JOINT_REVOLUTE, anchor, bob, 0.0f, 0.0f);
	if (set_last)
		OK(scree_body_set_mass(world, bob, mass));
	read = mass_of(world, bob);
	assert_true(read.inertia == mass.inertia);
	warning_count = 0;
	float right = 0.0f;
	for (int step = 0; step < 120; ++step)
	{
		run_steps(world, 1);
		scree_vec at = position_of(world, bob);
		NEAR(hypotf(at.x, at.y), 1.0, 0.01);
		right = at.x > right ? at.x : right;
	}
	NEAR(right, sin(1.0471976), 0.02);
	assert_int_equal(warning_count, 0);
	scree_world_destroy(world);
}

static void long_arms_do_not_freeze(void** state)
{
	(void)state;
	beads_at_long_arms(SCREE_JOINT_WELD);
	beads_at_long_arms(SCREE_JOINT_REVOLUTE);
	pendulum_without_inertia(false);
	pendulum_without_inertia(true);
}

// Adds a circle with a given mass, which may be from 1e-15 to 1e30 kg.
static scree_body add_mass(scree_world* world, float mass, float x, float y)
{
	scree_body body = add_shape(world, SCREE_BODY_DYNAMIC, circle_shape(0.2f), x, y, 0.0f);
	OK(scree_body_set_mass(world, body, (scree_mass){.mass = mass, .inertia = 0.02f * mass}));
	return body;
}

// Rows of bodies, and wheels of bodies around one body, fall and turn fast. The masses of their bodies are very
// different. No body freezes, but joints may open.
static void unequal_masses_do_not_freeze(void** state)
{
	(void)state;
	const float masses[] = {1e-12f, 1e-9f, 1e-6f, 1e-4f};
	warning_count = 0;
	for (int k = 0; k < 4 * 2 * 2; ++k)
	{
		scree_world* world = open_world(-10.0f);
		scree_joint_type type = k / 4 % 2 ? SCREE_JOINT_WELD : SCREE_JOINT_REVOLUTE;
		scree_body first = add_mass(world, masses[k % 4], 0.0f, 0.0f), last = first;
		for (int n = 1; n < 16; ++n)
		{
			bool row = k / 8 == 0;
			float x = row ? (float)n : cosf(0.4f * (float)n), y = row ? 0.0f : sinf(0.4f * (float)n);
			scree_body body = add_mass(world, n % (row ? 4 : 15) == 0 ? 10.0f : masses[k % 4], x, y);
			join(world, type, row ? last : first, body, row ? x - 0.5f : 0.5f * x, 0.5f * y);
			throw_body(world, body, 300.0f, 90.0f * (float)(n % 3), 150.0f);
			last = body;
		}
		for (int step = 0; step < 120; ++step)
		{
			run_steps(world, 1);
			assert_int_equal(counters_of(world).frozen_bodies, 0);
		}
		scree_world_destroy(world);
	}
	assert_int_equal(warning_count, 0);
}

// A box of 1 kg with the smallest valid inertia falls on a floor, corner first. A second such box, whose shape was a
// sensor for a while, does the same. No body freezes.
static void contacts_without_inertia_do_not_freeze(void** state)
{
	(void)state;
	scree_mass mass = {.mass = 1.0f, .inertia = 1.0e-20f}, read;
	scree_world* world = open_world(-10.0f);
	add_box(world, SCREE_BODY_STATIC, 50.0f, 1.0f, 0.0f, -1.0f);
	warning_count = 0;
	scree_body boxes[2];
	for (int k = 0; k < 2; ++k)
	{
		boxes[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.1f, 2.0f * (float)k, 1.0f);
		OK(scree_body_set_pose(world, boxes[k], (scree_pose){{2.0f * (float)k, 1.0f}, {cosf(0.6f), sinf(0.6f)}}));
		throw_body(world, boxes[k], 20.0f, -50.0f, 0.0f);
	}
	scree_collidable shape;
	int count = 0;
	OK(scree_body_get_collidables(world, boxes[1], &shape, 1, &count));
	OK(scree_collidable_set_sensor(world, shape, SCREE_SENSOR_STATIC));
	for (int k = 0; k < 2; ++k)
		OK(scree_body_set_mass(world, boxes[k], mass));
	OK(scree_collidable_set_sensor(world, shape, 0));
	run_steps(world, 240);
	for (int k = 0; k < 2; ++k)
	{
		read = mass_of(world, boxes[k]);
		assert_true(read.inertia == mass.inertia);
		// the box overlaps the floor, but does not sink through it
		NEAR(position_of(world, boxes[k]).y, 0.06, 0.04);
	}
	assert_int_equal(warning_count, 0);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(bodies_freeze), cmocka_unit_test(sums_end_at_the_most),
	                                   cmocka_unit_test(long_arms_do_not_freeze),
	                                   cmocka_unit_test(unequal_masses_do_not_freeze),
	                                   cmocka_unit_test(contacts_without_inertia_do_not_freeze)};
	return cmocka_run_group_tests(tests, keep_log, release_log);
}
