// SPDX-License-Identifier: MIT
// test_bad_rules.c -- checks that the functions of rules refuse bad arguments with a message, and change nothing.
#include "support/bad_input.h"
#include <math.h>

static void materials(void** state)
{
	(void)state;
	scree_material_pair pair = scree_material_pair_default();
	INVALID(scree_world_set_material_pair, (NULL, 0, 1, &pair), "world is null");
	INVALID(scree_world_set_material_pair, (world, -1, 1, &pair), "material_a is -1, must be from 0 to 255");
	INVALID(scree_world_set_material_pair, (world, 0, 256, &pair), "material_b is 256");
	pair.friction = -1.0f;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.friction is -1, must be from 0 to 1000000");
	pair.friction = INFINITY;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.friction is inf");
	pair = scree_material_pair_default();
	pair.restitution = 101.0f;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.restitution is 101");
	pair = scree_material_pair_default();
	pair.tangent_speed = 1e6f;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.tangent_speed is 1000000");
	pair.size = 3;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.size is 3");
	INVALID(scree_world_get_material_pair, (world, 0, 999, &pair), "material_b is 999");
	INVALID(scree_world_get_material_pair, (world, 0, 1, NULL), "pair is null");
}

static void exclusions(void** state)
{
	(void)state;
	scree_body two[2] = {body, second}, bad[2] = {second, stale}, same[2] = {second, second};
	bool both[2] = {true, true};
	int count;
	INVALID(scree_body_set_excluded, (NULL, body, second, true), "world is null");
	INVALID(scree_body_set_excluded, (world, body, body, true), "other is the same body (index");
	STALE(scree_body_set_excluded, (world, stale, body, true), "body (index");
	STALE(scree_body_set_excluded, (world, body, SCREE_NULL_BODY, true), "other is null");
	STALE(scree_bodies_set_excluded, (world, two, bad, both, 2), "b[1] (index");
	INVALID(scree_bodies_set_excluded, (world, two, same, both, 2), "b[1] is the same body");
	INVALID(scree_bodies_set_excluded, (world, two, NULL, both, 2), "b is null");
	INVALID(scree_bodies_set_excluded, (world, two, bad, NULL, 2), "excluded is null");
	INVALID(scree_bodies_set_excluded, (world, two, bad, both, -1), "count is -1");
	STALE(scree_body_get_excluded, (world, stale, two, 2, &count), "body (index");
	INVALID(scree_body_get_excluded, (world, body, NULL, 2, &count), "others is null");
	INVALID(scree_body_get_excluded, (world, body, two, 2, NULL), "count is null");
	assert_true(!scree_body_is_excluded(NULL, body, second) && !scree_body_is_excluded(world, body, stale));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(materials), cmocka_unit_test(exclusions)};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input);
}
