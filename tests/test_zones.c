// SPDX-License-Identifier: MIT
// test_zones.c -- checks the zones for the profiler Tracy, of a build with SCREE_TRACY: names, order, ends.
#include "support/make_bodies.h"
#include "support/task_pool.h"
#include "tracy/TracyC.h"
#include <stdatomic.h>
#include <string.h>

#define ZONES 256
#define DEPTH 8

static _Thread_local const char* open_zones[DEPTH]; // zones of this thread that have not ended
static _Thread_local int depth;
static const char* begun[ZONES]; // zones of the thread of the test
static int begun_count;
static bool counts; // true: zones of the thread of the test are listed
static atomic_int task_zones, wrong;

TracyCZoneCtx zone_begin(const char* name)
{
	bool task = strcmp(name, "scree: task") == 0;
	atomic_fetch_add(&task_zones, task);
	atomic_fetch_add(&wrong, depth >= DEPTH);
	open_zones[depth++] = name;
	if (!task && counts && begun_count < ZONES)
		begun[begun_count++] = name;
	return (TracyCZoneCtx){name};
}

void zone_end(TracyCZoneCtx zone)
{
	atomic_fetch_add(&wrong, depth == 0 || strcmp(open_zones[--depth], zone.name) != 0);
}

// Returns the index of a zone among those that have begun, or -1.
static int place_of(const char* name)
{
	for (int k = 0; k < begun_count; ++k)
		if (strcmp(begun[k], name) == 0)
			return k;
	return -1;
}

static scree_world* piled_world(const scree_tasks* tasks)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 4;
	def.tasks = tasks;
	scree_world* world = create_world(&def);
	add_floor(world);
	for (int k = 0; k < 2000; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 1.01f * (float)(k % 100), 0.5f + (float)(k / 100));
	return world;
}

// A step begins its own zone, that of the upload if something is new, then those of the stages.
static void test_zones_of_a_step(void** state)
{
	(void)state;
	static const char* const stages[] = {"scree: transform", "scree: broad_phase", "scree: narrow_phase",
	                                     "scree: color",     "scree: solve",       "scree: finalize"};
	scree_world* world = piled_world(NULL);
	for (int round = 0; round < 2; ++round)
	{
		begun_count = 0;
		counts = true;
		run_steps(world, 1);
		counts = false;
		assert_int_equal(depth, 0);
		assert_string_equal(begun[0], "scree_world_step");
		assert_int_equal(place_of("scree: upload"), round == 0 ? 1 : -1);
		for (int k = 0; k < 6; ++k) // in the second step no box changes, so the broad phase has no items
			assert_true(place_of(stages[k]) > 0 || (round == 1 && k == 1));
		assert_true(place_of("scree: finalize") > place_of("scree: solve"));
	}
	assert_int_equal(scree_world_step(world, -1.0f, 4), SCREE_ERROR_INVALID);
	assert_int_equal(depth, 0);
	assert_int_equal(atomic_load(&wrong), 0);
	scree_world_destroy(world);
}

static void test_zones_of_queries(void** state)
{
	(void)state;
	scree_world* world = piled_world(NULL);
	scree_query_result found;
	begun_count = 0;
	counts = true;
	for (int k = 0; k < 2; ++k)
		OK(scree_world_cast_ray(world, (scree_vec){-5.0f, 0.5f}, (scree_vec){10.0f, 0.0f}, &found));
	counts = false;
	assert_true(found.hit);
	assert_string_equal(begun[0], "scree: upload");
	int place = place_of("scree: prepare queries");
	assert_true(place > 0);
	for (int k = place + 1; k < begun_count; ++k) // the second query has nothing to prepare
		assert_string_not_equal(begun[k], begun[place]);
	assert_int_equal(depth, 0);
	assert_int_equal(atomic_load(&wrong), 0);
	scree_world_destroy(world);
}

// A task of the user's pool has a zone on its thread.
static void test_zones_of_tasks(void** state)
{
	(void)state;
	TaskPool pool;
	pool_open(&pool, POOL_PLAIN, 3);
	scree_tasks tasks = pool_tasks(&pool);
	scree_world* world = piled_world(&tasks);
	run_steps(world, 5);
	scree_world_destroy(world);
	pool_close(&pool);
	assert_int_equal(atomic_load(&task_zones), pool.calls);
	assert_true(pool.calls > 0);
	assert_int_equal(atomic_load(&wrong), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_zones_of_a_step), cmocka_unit_test(test_zones_of_queries),
	                                   cmocka_unit_test(test_zones_of_tasks)};
	return cmocka_run_group_tests(tests, NULL, memory_is_released);
}
