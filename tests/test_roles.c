// SPDX-License-Identifier: MIT
// test_roles.c -- checks that pools with the role scratch do not carry data from one step to the next.
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"
#include "world/world.h"

// Writes random bytes into all scratch pools of a world.
static void spoil(scree_world* world, uint64_t* seed)
{
	Backend* b = world->backend;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		if (pool_info[pool].role != SCRATCH)
			continue;
		int items = b->capacity[pool_info[pool].per];
		size_t bytes = pool_info[pool].bytes * (size_t)items;
		unsigned char* rows = scree_allocate(bytes + 1);
		assert_non_null(rows);
		for (size_t k = 0; k < bytes; ++k)
			rows[k] = (unsigned char)random_word(seed);
		OK(b->f->write(b, (PoolId)pool, 0, items, rows));
		OK(b->f->wait(b));
		scree_release(rows);
	}
}

// Creates a heap of boxes and circles on a plate that is a hub. The circles bounce and have rolling resistance.
static scree_world* heap(void)
{
	scree_world* world = open_world(-10.0f);
	scree_attribute_def ball = surface_of(circle_shape(0.3f));
	ball.restitution = 0.5f;
	ball.rolling_resistance = 0.01f;
	scree_attribute round = add_attribute(world, &ball);
	add_floor(world);
	add_box(world, SCREE_BODY_DYNAMIC, 30.0f, 0.5f, 0.0f, 0.5f);
	for (int k = 0; k < 120; ++k)
	{
		float x = 0.7f * (float)(k % 60) - 20.0f, y = 1.4f + 0.8f * (float)(k / 60);
		if (k % 7 == 0)
			add_body(world, SCREE_BODY_DYNAMIC, round, x, y, 0.0f);
		else
			add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.25f, x, y);
	}
	return world;
}

static void scratch_is_scratch(void** state)
{
	(void)state;
	uint64_t seed = 1;
	scree_world *plain = heap(), *spoiled = heap();
	for (int step = 0; step < 60; ++step)
	{
		scree_body thrown = {0};
		for (int w = 0; w < 2; ++w)
		{
			scree_world* world = w == 0 ? plain : spoiled;
			if (step % 10 == 3)
				thrown = add_box(world, SCREE_BODY_DYNAMIC, 0.2f, 0.2f, (float)step - 30.0f, 5.0f);
			if (step % 10 == 5)
			{
				OK(scree_world_get_bodies(world, &thrown, 1, &(int){0}));
				OK(scree_body_apply_impulse(world, thrown, (scree_vec){0.1f, 0.2f}));
			}
			run_steps(world, 1);
		}
		spoil(spoiled, &seed);
		assert_int_equal(hash_of(spoiled), hash_of(plain));
	}
	assert_true(counters_of(plain).spokes > 32);
	scree_world_destroy(plain);
	scree_world_destroy(spoiled);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(scratch_is_scratch)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
