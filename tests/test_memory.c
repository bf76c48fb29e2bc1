// SPDX-License-Identifier: MIT
// test_memory.c -- checks that a growing world may run out of memory at any of its allocations.
#include "support/allocations.h"
#include <stdlib.h>

// Creates a world, adds 40 boxes in each of 20 rounds, and takes one step after the rounds. Returns the status of the
// first call that fails. Adds the number of created boxes to *bodies.
static scree_status build(scree_world** world, int* bodies)
{
	scree_world_def world_def = scree_world_def_default();
	world_def.device = "cpu";
	world_def.threads = 1;
	scree_attribute_def box = scree_attribute_def_default();
	scree_body_def defs[40];
	scree_attribute attribute;
	scree_status status = scree_world_create(&world_def, world);
	if (status == SCREE_OK)
		status = scree_attribute_create(*world, &box, &attribute);
	for (int k = 0; k < 40 && status == SCREE_OK; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = attribute;
		defs[k].pose.position.y = 1.5f * (float)k;
	}
	for (int round = 0; round < 20 && status == SCREE_OK; ++round)
	{
		status = scree_bodies_create(*world, defs, 40, NULL);
		*bodies += status == SCREE_OK ? 40 : 0;
	}
	return status == SCREE_OK ? scree_world_step(*world, 0.01f, 2) : status;
}

// Lets memory run out at each allocation in turn. The call that fails returns a status, and nothing is lost or changed.
static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	shortage_passes = true;
	int refused = 0;
	bool done = false;
	for (int allowed = 0; !done; ++allowed)
	{
		scree_world* made = NULL;
		int bodies = 0;
		allocations_left = allowed;
		scree_status status = build(&made, &bodies);
		done = allocations_left >= 0;
		if (status != SCREE_OK)
		{
			assert_int_equal(status, SCREE_ERROR_OUT_OF_MEMORY);
			++refused;
		}

		// memory is available from here on, so the next step succeeds, unless the failed call was a step that broke the
		// world (see test_faults.c)
		allocations_left = -1;
		if (made)
		{
			int count;
			OK(scree_world_get_bodies(made, NULL, 0, &count));
			assert_int_equal(count, bodies);
			if (scree_world_wait(made) == SCREE_OK)
				OK(scree_world_step(made, 0.01f, 2));
			else
				assert_int_equal(bodies, 800);
		}
		scree_world_destroy(made);
		assert_int_equal(scree_memory(), 0);
	}
	assert_true(refused > 20);
	OK(scree_hooks_set(NULL));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(memory_runs_out)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
