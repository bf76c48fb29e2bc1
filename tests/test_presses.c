// SPDX-License-Identifier: MIT
// test_presses.c -- what something kinematic presses against something static, on every way; masses that the user sets.
#include "support.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

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
		assert_true(position_of(world, plate).x < -0.5f + 0.08f);
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
	    cmocka_unit_test(hubs_yield_to_what_is_static),
	    cmocka_unit_test(presses_are_equal_everywhere),
	    cmocka_unit_test(own_mass_outlives_types),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
