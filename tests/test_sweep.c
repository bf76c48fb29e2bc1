// SPDX-License-Identifier: MIT
// test_sweep.c -- fast bodies: they stop where they meet something, and what they would pass by does not stop them.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support.h"
#include <math.h>
#include <stdlib.h>

#define SHAPES 4
#define PHASES 16 // starts, a fraction of a step's way apart

// A shape, all about 1 m wide and with its lowest point 0.5 m below its origin.
static scree_shape shape_of(int kind)
{
	scree_shape shape = box_shape(0.5f, 0.5f);
	if (kind == 1)
		shape = circle_shape(0.5f);
	if (kind == 2)
		OK(scree_shape_make_capsule((scree_vec){-0.2f, 0.0f}, (scree_vec){0.2f, 0.0f}, 0.5f, &shape));
	if (kind == 3)
		OK(scree_shape_make_polygon((scree_vec[]){{-0.4f, -0.4f}, {0.4f, -0.4f}, {0.0f, 0.3f}}, 3, 0.1f, &shape));
	return shape;
}

static scree_body throw_body(scree_world* world, scree_shape shape, float restitution, scree_vec from, scree_vec v)
{
	scree_attribute_def def = surface_of(shape);
	def.restitution = restitution;
	def.friction = 0.0f;
	scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), from.x, from.y, 0.0f);
	OK(scree_body_set_velocity(world, body, (scree_velocity){v, 0.0f}));
	return body;
}

// v(t) = v0: a body that flies over a stack with a centimetre to spare, or down beside it, feels nothing of it.
static void passes_by(void** state)
{
	(void)state;
	for (int kind = 0; kind < SHAPES; ++kind)
		for (int phase = 0; phase < PHASES; ++phase)
			for (int way = 0; way < 3; ++way)
			{
				scree_world* world = open_world(0.0f);
				for (int k = 0; k < 3; ++k)
					add_box(world, SCREE_BODY_STATIC, 0.5f, 0.5f, 0.0f, (float)k - 2.5f);

				// along its top; down its side; and slantwise over its corner
				float back = 3.0f + (float)phase / PHASES, side = kind == 2 ? 0.7f : 0.5f;
				scree_vec from = {-back, 0.51f}, v = {60.0f, 0.0f};
				if (way == 1)
				{
					from = (scree_vec){-0.5f - side - 0.01f, back};
					v = (scree_vec){0.0f, -60.0f};
				}
				if (way == 2)
				{
					// the corner (0.5, 0) is passed by the body's lower left corner, or nearer than that by a round one
					from = (scree_vec){0.51f + side - back, 0.5f + back};
					v = (scree_vec){40.0f, -40.0f};
				}
				scree_body body = throw_body(world, shape_of(kind), 0.0f, from, v);
				run_steps(world, 8);
				NEAR(velocity_of(world, body).linear.x, v.x, 1e-5);
				NEAR(velocity_of(world, body).linear.y, v.y, 1e-5);
				NEAR(velocity_of(world, body).angular, 0.0, 1e-5);
				scree_world_destroy(world);
			}
}

// A wall of 5 cm holds what comes at 60 m/s, a metre a step, and no face overlaps it by more than the slop.
static void thin_wall(void** state)
{
	(void)state;
	for (int kind = 0; kind < SHAPES; ++kind)
		for (int phase = 0; phase < PHASES; ++phase)
		{
			scree_world* world = open_world(0.0f);
			add_box(world, SCREE_BODY_STATIC, 0.025f, 5.0f, 0.0f, 0.0f);
			scree_body body = throw_body(world, shape_of(kind), 0.0f, (scree_vec){-3.0f - (float)phase / PHASES, 0.0f},
			                             (scree_vec){60.0f, 7.0f});
			float deepest = deepest_of(world, 10);
			assert_true(position_of(world, body).x < 0.0f);
			assert_true(deepest <
			            (kind == 3 ? 0.08f : 0.005f)); // a triangle is hit at a corner and spins by a radian a step
			scree_world_destroy(world);
		}
}

// v' = -e v for every e (Newton's law of impact), wherever within a step the wall is met.
static void bounces(void** state)
{
	(void)state;
	for (int phase = 0; phase < PHASES; ++phase)
		for (int k = 1; k <= 4; ++k)
		{
			scree_world* world = open_world(0.0f);
			add_box(world, SCREE_BODY_STATIC, 0.5f, 5.0f, 0.0f, 0.0f);
			scree_body body = throw_body(world, circle_shape(0.5f), 0.25f * (float)k,
			                             (scree_vec){-3.0f - (float)phase / PHASES, 0.0f}, (scree_vec){60.0f, 0.0f});
			float deepest = deepest_of(world, 10);
			NEAR(velocity_of(world, body).linear.x, -15.0 * k, 0.01);
			assert_true(deepest < 0.005f);
			scree_world_destroy(world);
		}
}

// Two bodies of equal mass that meet head on with e = 1 exchange their velocities.
static void meets_head_on(void** state)
{
	(void)state;
	for (int phase = 0; phase < PHASES; ++phase)
	{
		scree_world* world = open_world(0.0f);
		float start = 2.0f + (float)phase / PHASES;
		scree_body a = throw_body(world, circle_shape(0.5f), 1.0f, (scree_vec){-start, 0.0f}, (scree_vec){50.0f, 0.0f});
		scree_body b = throw_body(world, circle_shape(0.5f), 1.0f, (scree_vec){start, 0.0f}, (scree_vec){-30.0f, 0.0f});
		run_steps(world, 10);
		NEAR(velocity_of(world, a).linear.x, -30.0, 0.01);
		NEAR(velocity_of(world, b).linear.x, 50.0, 0.01);
		scree_world_destroy(world);
	}
}

// A blade of 4 m that turns at 10 rad/s, a sixth of a radian a step, does not cut into what lies in its way.
static void blade(void** state)
{
	(void)state;
	for (int kind = 0; kind < SHAPES; ++kind)
		for (int phase = 0; phase < PHASES; ++phase)
		{
			scree_world* world = open_world(0.0f);
			float angle = 0.2f * (float)PI + 0.35f * (float)phase / PHASES;
			scree_attribute_def def = surface_of(box_shape(2.0f, 0.1f));
			scree_body turning =
			    add_body(world, SCREE_BODY_KINEMATIC, add_attribute(world, &def), 0.0f, 0.0f, angle - 0.5f * (float)PI);
			OK(scree_body_set_velocity(world, turning, (scree_velocity){{0.0f, 0.0f}, 10.0f}));
			scree_body body = throw_body(world, shape_of(kind), 0.0f, (scree_vec){1.0f, 1.0f}, (scree_vec){0.0f, 0.0f});
			float deepest = deepest_of(world, 20);
			assert_true(deepest < 0.12f);
			scree_vec at = position_of(world, body);
			assert_true(hypotf(at.x - 1.0f, at.y - 1.0f) > 1.0f);
			scree_world_destroy(world);
		}
}

// A box slides over the seams of a floor of slabs without friction: v(t) = v0.
static void seams(void** state)
{
	(void)state;
	for (int phase = 0; phase < PHASES; ++phase)
	{
		scree_world* world = open_world(-10.0f);
		for (int k = 0; k < 24; ++k)
			add_box(world, SCREE_BODY_STATIC, 0.5f, 0.5f, (float)k, -0.5f);
		scree_body body = throw_body(world, shape_of(0), 0.0f, (scree_vec){0.53f + (float)phase / PHASES, 0.5f},
		                             (scree_vec){20.0f, 0.0f});
		run_steps(world, 55);
		NEAR(velocity_of(world, body).linear.x, 20.0, 0.01);
		NEAR(position_of(world, body).y, 0.5, 0.002);
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(passes_by),     cmocka_unit_test(thin_wall), cmocka_unit_test(bounces),
	    cmocka_unit_test(meets_head_on), cmocka_unit_test(blade),     cmocka_unit_test(seams),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
