// SPDX-License-Identifier: MIT
// bad_input.c -- makes a world for calls with bad arguments, and checks that they are refused.
#include "support/bad_input.h"
#include <string.h>

scree_world *world, *other;
scree_attribute crate, foreign;
scree_body body, second, fixed, stale;
scree_collidable part, zone, stale_part;
uint64_t before;

void assert_refused(scree_status status, scree_status expected, const char* function, const char* part_of)
{
	if (status != expected || !strstr(scree_error(), function) || !strstr(scree_error(), part_of))
		fail_msg("%s: \"%s\" instead of %s: \"%s: ... %s\"", scree_status_name(status), scree_error(),
		         scree_status_name(expected), function, part_of);
	assert_int_equal(hash_of(world), before);
	scree_counters counters = counters_of(world);
	assert_int_equal(counters.bodies, 3);
	assert_int_equal(counters.collidables, 4);
	assert_int_equal(counters.attributes, 1);
}

int set_up_bad_input(void** state)
{
	(void)state;
	world = open_world((float)-G);
	other = open_world((float)-G);
	scree_attribute_def box = scree_attribute_def_default();
	crate = add_attribute(world, &box);
	box.friction = 0.1f;
	foreign = add_attribute(other, &box);
	scree_body_def defs[4];
	scree_body bodies[4];
	for (int k = 0; k < 4; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].pose.position.y = (float)k;
		defs[k].attribute = crate;
	}
	defs[0].type = SCREE_BODY_STATIC;
	OK(scree_bodies_create(world, defs, 4, bodies));
	fixed = bodies[0];
	body = bodies[1];
	second = bodies[2];
	stale = bodies[3];
	part = collidable_of(world, body);
	stale_part = collidable_of(world, stale);
	OK(scree_body_destroy(world, stale));
	scree_collidable_def zone_def = scree_collidable_def_default();
	zone_def.attribute = crate;
	zone = create_collidable(world, &zone_def);
	run_steps(world, 1);
	before = hash_of(world);
	return 0;
}

int tear_down_bad_input(void** state)
{
	scree_world_destroy(world);
	scree_world_destroy(other);
	scree_world_destroy(NULL);
	return memory_is_released(state);
}
