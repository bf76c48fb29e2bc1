// SPDX-License-Identifier: MIT
// test_finite.c -- checks that extreme finite values move bodies within the limits, and that a value that is not finite
// freezes only the body that has it.
#include "support/log_lines.h"
#include "support/make_bodies.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

// Opens a world with one box of 1 kg, and writes the handle of the box to body.
static scree_world* open_lonely(scree_body* body)
{
	scree_world* world = open_world(0.0f);
	*body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	return world;
}

// A finite force f leads to the speed min(h f / m, max_speed) in the direction of the force, without a warning.
static void forces_lead_to_the_limit(void** state)
{
	(void)state;
	const float sizes[] = {1e6f, 1e15f, 1e19f, 1e20f, 1e22f, 1e30f, 1e38f, FLT_MAX};
	for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k)
		for (int impulse = 0; impulse <= 1; ++impulse)
		{
			scree_body body;
			scree_world* world = open_lonely(&body);
			scree_vec f = {0.6f * sizes[k], -0.8f * sizes[k]};
			OK(impulse ? scree_body_apply_impulse(world, body, f) : scree_body_apply_force(world, body, f));
			run_steps(world, 1);
			scree_velocity v = velocity_of(world, body);
			double expected = impulse || sizes[k] > 1e6f ? 400.0 : 400.0 < sizes[k] / 60.0 ? 400.0 : sizes[k] / 60.0;
			NEAR(hypot(v.linear.x, v.linear.y), expected, 0.01);
			NEAR(v.linear.x, 0.6 * expected, 0.01);
			NEAR(v.linear.y, -0.8 * expected, 0.01);
			assert_int_equal(counters_of(world).frozen_bodies, 0);
			run_steps(world, 2);
			scree_world_destroy(world);
		}
	assert_int_equal(warning_count, 0);
}

// Gravity whose square is beyond a float leads to max_speed, without a warning.
static void gravity_leads_to_the_limit(void** state)
{
	(void)state;
	scree_body body;
	scree_world* world = open_lonely(&body);
	OK(scree_world_set_gravity(world, (scree_vec){0.0f, 1e25f}));
	run_steps(world, 1);
	NEAR(velocity_of(world, body).linear.y, 400.0, 0.01);
	assert_int_equal(warning_count, 0);
	scree_world_destroy(world);
}

// Bodies have densities, friction and rolling resistance from the smallest to the largest values. All states are
// finite, no warning is logged, and the bodies lie on the floor.
static void surfaces_may_be_extreme(void** state)
{
	(void)state;
	const float values[] = {0.0f, 1e-45f, 1e-30f, 1e-10f, 1.0f, 1e3f, 1e6f};
	const float densities[] = {0.0f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e9f};
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body bodies[14];
	for (int k = 0; k < 14; ++k)
	{
		scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
		def.density = densities[k % 7];
		def.friction = values[(k + k / 7) % 7];
		def.rolling_resistance = values[(2 * k) % 7];
		bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), 3.0f * (float)k, 0.6f, 0.0f);
	}
	run_steps(world, 60);
	check_finite(world);
	assert_int_equal(warning_count, 0);
	for (int k = 0; k < 14; ++k)
		NEAR(position_of(world, bodies[k]).y, 0.5, 0.02);
	scree_world_destroy(world);
}

// The middle body of a stack is pushed out by two forces whose sum is beyond a float. No body is frozen, and all
// impulses are finite.
static void one_body_leaves(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body stack[5];
	for (int k = 0; k < 5; ++k)
		stack[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f + (float)k);
	run_steps(world, 30);
	OK(scree_body_apply_force(world, stack[2], (scree_vec){FLT_MAX, 0.0f}));
	OK(scree_body_apply_force(world, stack[2], (scree_vec){FLT_MAX, 0.0f}));
	run_steps(world, 1);
	assert_int_equal(counters_of(world).frozen_bodies, 0);
	scree_contact* contacts;
	int count = read_contacts(world, &contacts);
	assert_in_range(count, 3, 9);
	for (int k = 0; k < count; ++k)
		for (int i = 0; i < contacts[k].count; ++i)
			assert_true(isfinite(contacts[k].points[i].normal_impulse) &&
			            isfinite(contacts[k].points[i].tangent_impulse));
	free(contacts);
	run_steps(world, 60);
	assert_int_equal(counters_of(world).frozen_bodies, 0);
	assert_int_equal(warning_count, 0);
	assert_true(position_of(world, stack[2]).x > 100.0f);
	NEAR(position_of(world, stack[0]).y, 0.5, 0.03);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(forces_lead_to_the_limit, keep_log, release_log),
	    cmocka_unit_test_setup_teardown(gravity_leads_to_the_limit, keep_log, release_log),
	    cmocka_unit_test_setup_teardown(surfaces_may_be_extreme, keep_log, release_log),
	    cmocka_unit_test_setup_teardown(one_body_leaves, keep_log, release_log),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
