// SPDX-License-Identifier: MIT
// test_bad_collidables.c -- checks that every function of collidables and contacts refuses bad arguments with a message
// that names argument and value, and changes nothing.
#include "support/bad_input.h"
#include <math.h>

static void collidable_definitions(void** state)
{
	(void)state;
	scree_collidable made[2];
	scree_collidable_def defs[2] = {scree_collidable_def_default(), scree_collidable_def_default()};
	defs[0].attribute = crate;
	INVALID(scree_collidables_create, (NULL, defs, 2, made), "world is null");
	INVALID(scree_collidables_create, (world, NULL, 2, made), "defs is null");
	INVALID(scree_collidables_create, (world, defs, -1, made), "count is -1");
#define DEF(status, change, sentence)                                                      \
	defs[1] = scree_collidable_def_default();                                              \
	defs[1].attribute = crate;                                                             \
	defs[1].change;                                                                        \
	REFUSED(scree_collidables_create, (world, defs, 2, made), status, "defs[1]" sentence); \
	REFUSED(scree_collidable_create, (world, &defs[1], made), status, "def" sentence)
	DEF(SCREE_ERROR_INVALID, size = 0, ".size is 0: the definition was not made by scree_collidable_def_default");
	DEF(SCREE_ERROR_STALE, attribute = foreign, ".attribute (index 0) is not an attribute");
	DEF(SCREE_ERROR_STALE, attribute.generation = 0, ".attribute is null");
	DEF(SCREE_ERROR_STALE, body = stale, ".body (index 4");
	DEF(SCREE_ERROR_INVALID, pose.position.x = NAN, ".pose.position.x is nan");
	DEF(SCREE_ERROR_INVALID, pose.rotation.c = -2, ".pose.rotation is (-2, 0)");
	DEF(SCREE_ERROR_INVALID, reports = 8, ".reports is 8, must be bits of SCREE_REPORT_TOUCHES");
	DEF(SCREE_ERROR_INVALID, sensor = 8, ".sensor is 8, must be bits of SCREE_SENSOR_MOVING");
#undef DEF
}

static void collidable_batches(void** state)
{
	(void)state;
	scree_collidable handles[2] = {part, stale_part};
	scree_pose poses[2] = {good_pose, good_pose};
	STALE(scree_collidables_destroy, (world, handles, 2), "collidables[1] (index 4");
	handles[1] = part;
	STALE(scree_collidables_destroy, (world, handles, 2), "collidables[1] is twice in the batch");
	INVALID(scree_collidables_destroy, (world, NULL, 2), "collidables is null");
	STALE(scree_collidable_destroy, (world, SCREE_NULL_COLLIDABLE), "collidable is null");
	assert_false(scree_collidable_is_valid(NULL, part));
	assert_false(scree_collidable_is_valid(world, stale_part));
	assert_true(scree_collidable_is_valid(world, part));

	handles[0] = zone;
	INVALID(scree_collidables_set_poses, (world, handles, poses, 2), "collidables[1] belongs to a body");
	INVALID(scree_collidables_set_poses, (world, handles, NULL, 2), "poses is null");
	handles[1] = zone;
	poses[1].position.y = NAN;
	INVALID(scree_collidables_set_poses, (world, handles, poses, 2), "poses[1].position.y is nan");
}

static void collidable_functions(void** state)
{
	(void)state;
	int count;
	scree_collidable made[2];
	scree_pose pose;
	scree_filter filter = scree_filter_default();
	scree_attribute attribute;
	scree_body owner;
	uint64_t user;
	INVALID(scree_body_get_collidables, (world, body, NULL, 1, &count), "collidables is null");
	INVALID(scree_body_get_collidables, (world, body, made, -1, &count), "capacity is -1");
	STALE(scree_body_get_collidables, (world, stale, made, 1, &count), "body (index 4");
	STALE(scree_collidable_get_body, (world, stale_part, &owner), "collidable (index");
	STALE(scree_collidable_get_attribute, (world, stale_part, &attribute), "collidable (index");
	STALE(scree_collidable_get_local_pose, (world, stale_part, &pose), "collidable (index");
	STALE(scree_collidable_get_filter, (world, stale_part, &filter), "collidable (index");
	STALE(scree_collidable_set_filter, (world, stale_part, filter), "collidable (index");
	STALE(scree_collidable_get_user, (world, stale_part, &user), "collidable (index");
	STALE(scree_collidable_set_user, (world, stale_part, 1), "collidable (index");
	INVALID(scree_collidable_get_body, (world, part, NULL), "body is null");
	INVALID(scree_collidable_get_attribute, (world, part, NULL), "attribute is null");
	INVALID(scree_collidable_get_local_pose, (world, part, NULL), "pose is null");
	INVALID(scree_collidable_get_filter, (world, part, NULL), "filter is null");
	INVALID(scree_collidable_get_user, (world, part, NULL), "user is null");
	INVALID(scree_collidable_set_filter, (NULL, part, filter), "world is null");
	INVALID(scree_collidable_set_attribute, (NULL, part, crate), "world is null");
	STALE(scree_collidable_set_attribute, (world, stale_part, crate), "collidable (index");
	STALE(scree_collidable_set_attribute, (world, SCREE_NULL_COLLIDABLE, crate), "collidable is null");
	STALE(scree_collidable_set_attribute, (world, part, (scree_attribute){0, 0}), "attribute is null");
	STALE(scree_collidable_set_attribute, (world, part, foreign),
	      "attribute (index 0) is not an attribute of this world");
}

static void event_functions(void** state)
{
	(void)state;
	scree_events events;
	uint32_t reports;
	INVALID(scree_world_get_events, (NULL, &events), "world is null");
	INVALID(scree_world_get_events, (world, NULL), "events is null");
	events.size = 8;
	assert_refused(scree_world_get_events_sized(world, &events), SCREE_ERROR_INVALID,
	               "scree_world_get_events: ", "events.size is 8");
	INVALID(scree_world_set_hit_thresholds, (NULL, 1.0f, 0.0f), "world is null");
	INVALID(scree_world_set_hit_thresholds, (world, -1.0f, 0.0f), "speed is -1");
	INVALID(scree_world_set_hit_thresholds, (world, 1.0f, NAN), "impulse is nan");
	INVALID(scree_collidable_set_reports, (NULL, part, 1), "world is null");
	INVALID(scree_collidable_set_reports, (world, part, 8), "reports is 8");
	STALE(scree_collidable_set_reports, (world, stale_part, 1), "collidable (index");
	STALE(scree_collidable_get_reports, (world, stale_part, &reports), "collidable (index");
	INVALID(scree_collidable_get_reports, (world, part, NULL), "reports is null");
}

static void contact_functions(void** state)
{
	(void)state;
	int count;
	scree_contact contact;
	INVALID(scree_world_get_contacts, (world, NULL, 1, &count), "contacts is null");
	INVALID(scree_world_get_contacts, (world, &contact, 1, NULL), "count is null");
	INVALID(scree_world_get_contacts, (NULL, &contact, 1, &count), "world is null");
	INVALID(scree_body_get_contacts, (NULL, body, &contact, 1, &count), "world is null");
	INVALID(scree_body_get_contacts, (world, body, NULL, 1, &count), "contacts is null");
	INVALID(scree_body_get_contacts, (world, body, &contact, 1, NULL), "count is null");
	INVALID(scree_body_get_contacts, (world, body, &contact, -1, &count), "capacity is -1");
	STALE(scree_body_get_contacts, (world, stale, &contact, 1, &count), "body (index 4");
	STALE(scree_body_get_contacts, (world, SCREE_NULL_BODY, &contact, 1, &count), "body is null");
	INVALID(scree_world_get_overlaps, (world, NULL, 1, &count), "overlaps is null");
	INVALID(scree_world_get_overlaps, (world, &contact, -1, &count), "capacity is -1");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(collidable_definitions), cmocka_unit_test(collidable_batches),
	    cmocka_unit_test(collidable_functions),   cmocka_unit_test(contact_functions),
	    cmocka_unit_test(event_functions),
	};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input);
}
