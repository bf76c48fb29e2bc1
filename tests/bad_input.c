// SPDX-License-Identifier: MIT
// bad_input.c -- the world of the tests of bad input.
#include "scree/scree.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "bad_input.h"
#include <string.h>

scree_world *world, *other;
scree_attribute crate, foreign;
scree_body body, second, fixed, stale;
scree_collidable part, zone, stale_part;
uint64_t before;

void assert_ok(scree_status status)
{
	if (status != SCREE_OK)
		fail_msg("%s: %s", scree_status_name(status), scree_error());
}

void assert_refused(scree_status status, scree_status expected, const char* function, const char* part_of)
{
	if (status != expected || !strstr(scree_error(), function) || !strstr(scree_error(), part_of))
		fail_msg("%s: \"%s\" instead of %s: \"%s: ... %s\"", scree_status_name(status), scree_error(),
		         scree_status_name(expected), function, part_of);
	uint64_t hash;
	assert_ok(scree_world_get_hash(world, &hash));
	assert_int_equal(hash, before);
	scree_counters counters;
	assert_ok(scree_world_get_counters(world, &counters));
	assert_int_equal(counters.bodies, 3);
	assert_int_equal(counters.collidables, 4);
	assert_int_equal(counters.attributes, 1);
}

int set_up_bad_input(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	assert_ok(scree_world_create(&def, &world));
	assert_ok(scree_world_create(&def, &other));
	scree_attribute_def box = scree_attribute_def_default();
	assert_ok(scree_attribute_create(world, &box, &crate));
	box.friction = 0.1f;
	assert_ok(scree_attribute_create(other, &box, &foreign));
	scree_body_def defs[4];
	scree_body bodies[4];
	for (int k = 0; k < 4; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].pose.position.y = (float)k;
		defs[k].attribute = crate;
	}
	defs[0].type = SCREE_BODY_STATIC;
	assert_ok(scree_bodies_create(world, defs, 4, bodies));
	fixed = bodies[0];
	body = bodies[1];
	second = bodies[2];
	stale = bodies[3];
	int count;
	assert_ok(scree_body_get_collidables(world, body, &part, 1, &count));
	assert_ok(scree_body_get_collidables(world, stale, &stale_part, 1, &count));
	assert_ok(scree_body_destroy(world, stale));
	scree_collidable_def zone_def = scree_collidable_def_default();
	zone_def.attribute = crate;
	assert_ok(scree_collidable_create(world, &zone_def, &zone));
	assert_ok(scree_world_step(world, 1.0f / 60.0f, 4));
	assert_ok(scree_world_get_hash(world, &before));
	return 0;
}

int tear_down_bad_input(void** state)
{
	(void)state;
	scree_world_destroy(world);
	scree_world_destroy(other);
	scree_world_destroy(NULL);
	return scree_memory() == 0 ? 0 : -1;
}
