// SPDX-License-Identifier: MIT
// test_presses.c -- what something kinematic presses against something static stays out of the static one, on every way.
#include "support.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#define DEPTH 0.02f // m: the most that a body may be in a wall

typedef struct
{
	scree_body press, wall, body;
} Press;

// A ball or a box of 1 m at rest before a wall whose face is at x = 0; a press of 1 m that begins at its left side, or a gap before it.
static Press add_press(scree_world* world, bool ball, float gap)
{
	scree_attribute_def def = surface_of(ball ? circle_shape(0.5f) : box_shape(0.5f, 0.5f));
	Press p;
	p.wall = add_box(world, SCREE_BODY_STATIC, 10.0f, 10.0f, 10.0f, 0.0f);
	p.press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 4.0f, -1.5f - gap, 1.7f);
	p.body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), -0.5f, 0.0f, 0.0f);
	return p;
}

// Whatever touches first, whatever the speed, by velocity and by target. After the press stops, the body rests.
static void static_side_wins(void** state)
{
	(void)state;
	static const float speeds[] = {0.25f, 0.5f, 1.0f, 5.0f, 20.0f};
	for (int k = 0; k < 40; ++k)
	{
		float speed = speeds[k / 8], gap = k & 1 ? 0.3f : 0.0f;
		scree_world* world = open_world(0.0f);
		Press p = add_press(world, k & 2, gap);
		for (float way = gap + 0.5f; way > 0.0f; way -= speed * STEP)
		{
			scree_pose to = {{position_of(world, p.press).x + speed * STEP, 1.7f}, {1.0f, 0.0f}};
			if (k & 4)
				OK(scree_bodies_set_targets(world, &p.press, &to, 1));
			else
				OK(scree_body_set_velocity(world, p.press, (scree_velocity){{speed, 0.0f}, 0.0f}));
			run_steps(world, 1);
			assert_true(position_of(world, p.body).x < -0.5f + DEPTH);
		}
		OK(scree_body_set_velocity(world, p.press, (scree_velocity){{0.0f, 0.0f}, 0.0f}));
		for (int step = 0; step < 60; ++step)
		{
			run_steps(world, 1);
			scree_vec v = velocity_of(world, p.body).linear;
			assert_true(position_of(world, p.body).x < -0.5f + DEPTH && hypotf(v.x, v.y) < speed + 0.01f);
		}
		scree_world_destroy(world);
	}
}

// The type of a body that touches changes: in the same step its contacts get the place that they have by the new type.
static void types_are_exchanged(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	Press p = add_press(world, true, 0.0f);
	run_steps(world, 10);
	OK(scree_body_set_type(world, p.press, SCREE_BODY_STATIC));
	OK(scree_body_set_type(world, p.wall, SCREE_BODY_KINEMATIC));
	for (int step = 0; step < 60; ++step)
	{
		OK(scree_body_set_velocity(world, p.wall, (scree_velocity){{-0.5f, 0.0f}, 0.0f}));
		run_steps(world, 1);
		assert_true(position_of(world, p.body).x > -0.5f - DEPTH);
	}
	scree_world_destroy(world);
}

// A hard target joint pulls a ball through a ring of segments: the ring holds it.
static void joints_yield_to_what_is_static(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_attribute_def ball = surface_of(circle_shape(0.3f)), side = ball;
	for (int k = 0; k < 32; ++k)
	{
		float a = (float)(k * 2.0 * PI / 32.0), b = (float)((k + 1) * 2.0 * PI / 32.0);
		OK(scree_shape_make_segment((scree_vec){3.0f * cosf(a), 3.0f * sinf(a)},
		                            (scree_vec){3.0f * cosf(b), 3.0f * sinf(b)}, &side.shape));
		add_body(world, SCREE_BODY_STATIC, add_attribute(world, &side), 0.0f, 0.0f, 0.0f);
	}
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_joint joint;
	scree_body_def hand_def = scree_body_def_default();
	hand_def.type = SCREE_BODY_KINEMATIC;
	OK(scree_body_create(world, &hand_def, &def.body_a));
	def.body_b = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &ball), 0.0f, 0.0f, 0.0f);
	OK(scree_joint_create(world, &def, &joint));
	for (int step = 0; step < 360; ++step)
	{
		scree_pose to = {{fminf(0.025f * (float)step, 6.0f), 0.2f * sinf(0.1f * (float)step)}, {1.0f, 0.0f}};
		OK(scree_bodies_set_targets(world, &def.body_a, &to, 1));
		run_steps(world, 1);
		scree_vec at = position_of(world, def.body_b);
		assert_true(hypotf(at.x, at.y) < 2.9f); // its middle; the ring is at 2.99 to 3
	}
	scree_world_destroy(world);
}

// A plate with 40 crates, a hub, between a press and a wall.
static scree_body add_plate(scree_world* world, scree_body* press)
{
	add_box(world, SCREE_BODY_STATIC, 50.0f, 100.0f, 50.0f, 0.0f);
	*press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 22.0f, -2.6f, 0.0f);
	scree_body plate = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 22.0f, -0.5f, 0.0f);
	for (int k = 0; k < 40; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.5f, -1.5f, 1.1f * (float)(k - 20));
	return plate;
}

static void hubs_yield_to_what_is_static(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body press, plate = add_plate(world, &press);
	for (int step = 0; step < 120; ++step)
	{
		OK(scree_body_set_velocity(world, press, (scree_velocity){{0.5f, 0.0f}, 0.0f}));
		run_steps(world, 1);
		assert_true(position_of(world, plate).x < -0.5f + DEPTH);
	}
	scree_world_destroy(world);
}

static void build_all(scree_world* world, const void* context)
{
	scree_body press, plate = add_plate(world, &press);
	const scree_velocity slow = {{0.5f, 0.0f}, 0.0f};
	(void)context;
	(void)plate;
	OK(scree_body_set_velocity(world, press, slow));
	for (int k = 0; k < 8; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f + 0.02f * (float)k, -0.4f, 30.0f + (float)k);
	press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 8.0f, -1.3f, 34.0f);
	OK(scree_body_set_velocity(world, press, slow));
}

static void presses_are_equal_everywhere(void** state)
{
	(void)state;
	Way ways[MAX_WAYS];
	int count = list_ways(ways);
	Story story = {.name = "presses",
	               .def = scree_world_def_default(),
	               .dt = STEP,
	               .substeps = SUBSTEPS,
	               .steps = 120,
	               .build = build_all};
	story.def.gravity = (scree_vec){0.0f, 0.0f};
	check_parity(&story, ways, count, NULL);
}

// A mass that the user set holds again after the body was kinematic, until its collidables change, then too.
static void own_mass_outlives_types(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.5f, 0.0f, 0.0f);
	scree_mass mass;
	OK(scree_body_set_mass(world, body, (scree_mass){2.0f, 0.5f, {1.0f, 0.0f}}));
	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	OK(scree_body_get_mass(world, body, &mass));
	assert_true(mass.mass == 0.0f);
	uint64_t kept = hash_of(world);
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	OK(scree_body_get_mass(world, body, &mass));
	assert_true(mass.mass == 2.0f && mass.inertia == 0.5f && mass.center.x == 1.0f);

	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	assert_true(hash_of(world) == kept);
	scree_collidable_def def = scree_collidable_def_default();
	scree_collidable added;
	scree_attribute_def surface = surface_of(box_shape(0.5f, 0.5f));
	def.body = body;
	def.attribute = add_attribute(world, &surface);
	OK(scree_collidable_create(world, &def, &added));
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	OK(scree_body_get_mass(world, body, &mass));
	NEAR(mass.mass, 2.0, 1e-6); // of two boxes of 1 kg
	NEAR(mass.center.x, 0.0, 1e-6);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(static_side_wins),
	    cmocka_unit_test(types_are_exchanged),
	    cmocka_unit_test(joints_yield_to_what_is_static),
	    cmocka_unit_test(hubs_yield_to_what_is_static),
	    cmocka_unit_test(presses_are_equal_everywhere),
	    cmocka_unit_test(own_mass_outlives_types),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
