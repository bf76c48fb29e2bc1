// SPDX-License-Identifier: MIT
// test_small.c -- checks that bodies of 2 to 20 mm rest on segments and boxes, do not pass through them, and keep their
// order.
#include "support/make_bodies.h"
#include <math.h>

static const float sizes[] = {0.002f, 0.003f, 0.004f, 0.005f, 0.007f, 0.01f, 0.02f};

// Returns a square or a circle of the given size, or a plate with a height of this size and a width of 0.5 m.
static scree_shape small_shape(int kind, float size)
{
	float half = 0.5f * size;
	return kind == 0 ? box_shape(half, half) : kind == 1 ? circle_shape(half) : box_shape(0.25f, half);
}

// Bodies fall from 0 to 2 m, flat or tilted, with 1 to 8 substeps. After 5 s their vertical speed is almost 0, and
// their centers are above the floor by more than 0 and less than 0.75 times their size.
static void fall_and_rest(void** state)
{
	(void)state;
	static const float drops[] = {0.0f, 0.02f, 0.1f, 0.5f, 2.0f};
	for (int k = 0; k < 2 * 3 * 7 * 4; ++k)
	{
		int segment = k % 2, kind = k / 2 % 3, substeps = 1 << k / 42;
		float size = sizes[k / 6 % 7], half = 0.5f * size;
		scree_world* world = open_world(-10.0f);
		add_shape(world, SCREE_BODY_STATIC, segment ? segment_shape(-20.0f, 0.0f, 20.0f, 0.0f) : box_shape(20.0f, 0.5f),
		          0.0f, segment ? 0.0f : -0.5f, 0.0f);
		scree_body bodies[10];
		for (int n = 0; n < 10; ++n)
		{
			float angle = n % 2 ? 0.3f : 0.0f, swing = kind == 2 ? 0.25f : half;
			float down = kind == 1 ? half : half * cosf(angle) + swing * sinf(angle);
			bodies[n] = add_shape(world, SCREE_BODY_DYNAMIC, small_shape(kind, size), 2.0f * (float)(n - 5),
			                      down + drops[n / 2], angle);
		}
		for (int step = 0; step < 300; ++step)
			OK(scree_world_step(world, STEP, substeps));
		for (int n = 0; n < 10; ++n)
		{
			float y = pose_of(world, bodies[n]).position.y;
			scree_velocity velocity = velocity_of(world, bodies[n]);
			if (!(y > 0.0f && y < 0.75f * size) || !(fabsf(velocity.linear.y) < 0.01f))
				fail_msg("run %d: kind %d of %g mm from %g m, %d substeps: at %g m with %g m/s", k, kind,
				         1e3 * (double)size, (double)drops[n / 2], substeps, (double)y, (double)velocity.linear.y);
		}
		scree_world_destroy(world);
	}
}

// Plates that fall on each other keep their order, although a plate moves farther in a step than its gap to the plate
// below.
static void plates_stay_in_order(void** state)
{
	(void)state;
	for (int k = 0; k < 7; ++k)
	{
		scree_world* world = open_world(-10.0f);
		add_shape(world, SCREE_BODY_STATIC, segment_shape(-20.0f, 0.0f, 20.0f, 0.0f), 0.0f, 0.0f, 0.0f);
		scree_body plates[10];
		for (int n = 0; n < 10; ++n)
			plates[n] = add_shape(world, SCREE_BODY_DYNAMIC, small_shape(2, sizes[k]), 0.01f * (float)(n % 3),
			                      1.5f * sizes[k] * ((float)n + 0.5f) + 0.01f, 0.0f);
		run_steps(world, 300);
		float below = 0.0f;
		for (int n = 0; n < 10; ++n)
		{
			float y = pose_of(world, plates[n]).position.y;
			if (!(y > below))
				fail_msg("plate %d of %g mm: at %g m over one at %g m", n, 1e3 * (double)sizes[k], (double)y,
				         (double)below);
			below = y;
		}
		scree_world_destroy(world);
	}
}

// A plate slides over the seams of a floor of tiles, and past their corners. Continuous collision must not treat this
// as a body that passes through the floor.
static void plates_slide_over_seams(void** state)
{
	(void)state;
	for (int k = 0; k < 7 * 16; ++k)
	{
		scree_world* world = open_world(-10.0f);
		float size = sizes[k % 7], speed = 0.5f * (float)(1 << k / 28);
		for (int n = 0; n < 20; ++n)
			add_shape(world, SCREE_BODY_STATIC, box_shape(0.25f, 0.1f), 0.5f * (float)n, -0.1f, 0.0f);
		scree_attribute_def surface = surface_of(small_shape(2, size));
		surface.friction = 0.0f;
		scree_body plate = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &surface),
		                            1.0f + 0.03f * (float)(k / 7), 0.5f * size, 0.0f);
		OK(scree_body_set_linear_velocity(world, plate, (scree_vec){speed, 0.0f}));
		run_steps(world, 90);
		scree_velocity velocity = velocity_of(world, plate);
		NEAR(velocity.linear.x, speed, 0.01 * (double)speed);
		NEAR(pose_of(world, plate).position.y, 0.5 * (double)size, 0.0005);
		scree_world_destroy(world);
	}
}

// A small triangle is up to 80 m from the origin of its body. It falls like a triangle at the origin, and rests after
// 0.6 s. An earlier version stopped it in the air and let it sink for 2 s.
static void shapes_far_from_their_origin(void** state)
{
	(void)state;
	for (int k = 0; k < 20; ++k)
	{
		scree_world* world = open_world(-10.0f);
		add_shape(world, SCREE_BODY_STATIC, segment_shape(-20.0f, 0.0f, 20.0f, 0.0f), 0.0f, 0.0f, 0.0f);
		float away = 4.0f * (float)(k + 1);
		scree_vec points[] = {{0.04f - away, 0.0f}, {0.01f - away, 0.03f}, {-0.05f - away, 0.01f}};
		scree_shape shape = polygon_shape(points, 3, 0.0f);
		scree_body body = add_shape(world, SCREE_BODY_DYNAMIC, shape, away, 1.42f, 0.0f);
		scree_mass mass = mass_of(world, body);
		run_steps(world, 36);
		scree_vec at;
		OK(scree_body_get_world_point(world, body, mass.center, &at));
		scree_velocity velocity = velocity_of(world, body);
		assert_true(at.y < 0.02f);
		NEAR(velocity.linear.y, 0.0, 0.01);
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(fall_and_rest),
	    cmocka_unit_test(plates_stay_in_order),
	    cmocka_unit_test(plates_slide_over_seams),
	    cmocka_unit_test(shapes_far_from_their_origin),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
