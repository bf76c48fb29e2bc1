// SPDX-License-Identifier: MIT
// test_bad_rules.c -- bad input to the functions of rules gets a sentence, and changes nothing.
#include "bad_input.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

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
	pair.restitution = 1.5f;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.restitution is 1.5");
	pair = scree_material_pair_default();
	pair.tangent_speed = 1e6f;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.tangent_speed is 1000000");
	pair.size = 3;
	INVALID(scree_world_set_material_pair, (world, 0, 1, &pair), "pair.size is 3");
	INVALID(scree_world_get_material_pair, (world, 0, 999, &pair), "material_b is 999");
	INVALID(scree_world_get_material_pair, (world, 0, 1, NULL), "pair is null");
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(materials)};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input);
}
