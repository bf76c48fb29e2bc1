// SPDX-License-Identifier: MIT
// test_bad_sleep.c -- checks that the functions of sleep refuse bad arguments with a message, and change nothing.
#include "support/bad_input.h"
#include "support/make_worlds.h"
#include <math.h>

static void wakes(void** state)
{
	(void)state;
	scree_body two[2] = {body, second}, bad[2] = {body, stale};
	bool both[2] = {true, false};
	INVALID(scree_body_set_awake, (NULL, body, true), "world is null");
	STALE(scree_body_set_awake, (world, stale, true), "body (index");
	STALE(scree_body_set_awake, (world, SCREE_NULL_BODY, false), "body is null");
	STALE(scree_bodies_set_awake, (world, bad, both, 2), "bodies[1] (index");
	INVALID(scree_bodies_set_awake, (world, NULL, both, 2), "bodies is null");
	INVALID(scree_bodies_set_awake, (world, two, NULL, 2), "awake is null");
	INVALID(scree_bodies_set_awake, (world, two, both, -1), "count is -1");
	STALE(scree_body_get_awake, (world, stale, both), "body (index");
	INVALID(scree_body_get_awake, (world, body, NULL), "awake is null");
	STALE(scree_bodies_get_awake, (world, bad, both, 2), "bodies[1] (index");
	INVALID(scree_bodies_get_awake, (world, two, NULL, 2), "awake is null");
	INVALID(scree_bodies_get_awake, (world, two, both, -2), "count is -2");
	INVALID(scree_bodies_get_awake, (NULL, two, both, 2), "world is null");
	INVALID(scree_world_set_awake, (NULL, true), "world is null");
	INVALID(scree_world_set_box_awake, (NULL, (scree_box){{0, 0}, {1, 1}}, true), "world is null");
	INVALID(scree_world_set_box_awake, (world, (scree_box){{0, 0}, {1, NAN}}, true), "box.upper.y is nan");
	INVALID(scree_world_set_box_awake, (world, (scree_box){{0, 0}, {-1, 1}}, true), "box");
	INVALID(scree_world_set_box_awake, (world, (scree_box){{0, 0}, {1e-3f, 1}}, false), "box");
}

static void settings(void** state)
{
	(void)state;
	scree_body_def def = scree_body_def_default();
	scree_world_def worlds = scree_world_def_default();
	scree_tuning tuning;
	scree_world* made = world;
	float threshold;
	bool stays;
	const float refused[] = {-1.0f, NAN, INFINITY, 1.1e6f};
	for (int k = 0; k < 4; ++k)
	{
		INVALID(scree_body_set_sleep_threshold, (world, body, refused[k]), "threshold is ");
		def.sleep_threshold = refused[k];
		INVALID(scree_body_create, (world, &def, NULL), "def.sleep_threshold is ");
		OK(scree_world_get_tuning(world, &tuning));
		tuning.sleep_threshold = refused[k];
		INVALID(scree_world_set_tuning, (world, &tuning), "tuning.sleep_threshold is ");
		worlds.sleep_threshold = refused[k];
		INVALID(scree_world_create, (&worlds, &made), "def.sleep_threshold is ");
	}
	worlds.sleep_threshold = 0.0f;
	INVALID(scree_world_create, (&worlds, &made), "def.sleep_threshold is 0, must be from 1e-06 to 1000000");
	INVALID(scree_body_set_sleep_threshold, (world, body, -1.0f), "threshold is -1, must be from 0 to 1000000");
	INVALID(scree_body_set_sleep_threshold, (NULL, body, 1.0f), "world is null");
	STALE(scree_body_set_sleep_threshold, (world, stale, 1.0f), "body (index");
	STALE(scree_body_get_sleep_threshold, (world, stale, &threshold), "body (index");
	INVALID(scree_body_get_sleep_threshold, (world, body, NULL), "threshold is null");
	INVALID(scree_body_set_stays_awake, (NULL, body, true), "world is null");
	STALE(scree_body_set_stays_awake, (world, stale, true), "body (index");
	STALE(scree_body_get_stays_awake, (world, stale, &stays), "body (index");
	INVALID(scree_body_get_stays_awake, (world, body, NULL), "stays_awake is null");
}

// A batch that is refused for its second body does not wake the world, although the first body carries a field.
static void refused_batches_wake_nothing(void** state)
{
	(void)state;
	scree_world* sleepers = open_world(0.0f);
	scree_body_def def = scree_body_def_default();
	scree_field_def field = scree_field_def_default(SCREE_FIELD_UNIFORM);
	scree_body carrier, sleeper;
	OK(scree_body_create(sleepers, &def, &carrier));
	field.body = carrier;
	field.disabled = true;
	OK(scree_field_create(sleepers, &field, NULL));
	def.asleep = true;
	OK(scree_body_create(sleepers, &def, &sleeper));
	const scree_body bodies[2] = {carrier, SCREE_NULL_BODY};
	const bool enabled[2] = {true, true};
	bool awake = true;
	assert_int_equal(scree_bodies_set_enabled(sleepers, bodies, enabled, 2), SCREE_ERROR_STALE);
	OK(scree_body_get_awake(sleepers, sleeper, &awake));
	assert_false(awake);
	scree_world_destroy(sleepers);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(wakes), cmocka_unit_test(settings),
	                                   cmocka_unit_test(refused_batches_wake_nothing)};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input);
}
