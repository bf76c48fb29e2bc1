// SPDX-License-Identifier: MIT
// test_readers.c -- checks functions that several threads call at the same time with one world: the results of one thread.
#include "platform/system.h"
#include "support/make_bodies.h"
#include "support/task_pool.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#define READERS 8
#define COLUMNS 30
#define ROWS    30
#define BODIES  (ROWS * COLUMNS)
#define SINGLE  40  // queries of one call each
#define BATCH   300 // queries of a call that may use the workers

typedef struct // all results of a reader
{
	scree_query_result single[SINGLE], shapes[SINGLE], nearest[SINGLE], batch[BATCH];
	int listed[SINGLE]; // number of results of each list
	uint64_t lists;     // hash of the results of lists
	scree_pose poses[BODIES];
	scree_velocity velocities[BODIES];
	scree_pose pose;
	scree_vec point, velocity;
} Results;

typedef struct
{
	scree_world* world;
	const scree_body* bodies;
	uint64_t seed; // start of the random numbers of its queries
	bool reads_first;
	Results* results;
	atomic_int* waiting; // number of readers that have not begun
	int failures;
} ReaderWork;

static uint64_t mix(uint64_t hash, const void* bytes, size_t count)
{
	for (size_t k = 0; k < count; ++k)
		hash = (hash ^ ((const unsigned char*)bytes)[k]) * 0x100000001b3u;
	return hash;
}

static uint64_t hash_list(uint64_t hash, const scree_query_results* list, int queries)
{
	hash = mix(hash, list->results, sizeof *list->results * (size_t)list->count);
	return mix(hash, list->first, sizeof *list->first * (size_t)(queries + 1));
}

static scree_vec random_vec(uint64_t* seed, float x, float y)
{
	float across = random_between(seed, 0.0f, x), up = random_between(seed, 0.0f, y);
	return (scree_vec){across, up};
}

// Makes the queries of a seed. Counts failures: cmocka checks only on the thread of the test.
static void read_bodies(ReaderWork* work)
{
	Results* r = work->results;
	scree_world* world = work->world;
	scree_body body = work->bodies[BODIES / 2];
	work->failures += scree_bodies_get_poses(world, work->bodies, r->poses, BODIES) != SCREE_OK;
	work->failures += scree_bodies_get_velocities(world, work->bodies, r->velocities, BODIES) != SCREE_OK;
	work->failures += scree_body_get_pose(world, body, &r->pose) != SCREE_OK;
	work->failures += scree_body_get_world_point(world, body, (scree_vec){1.0f, 0.0f}, &r->point) != SCREE_OK;
	work->failures += scree_body_get_point_velocity(world, body, r->point, &r->velocity) != SCREE_OK;
}

static void make_lists(ReaderWork* work, int k, scree_ray ray, scree_shape shape)
{
	Results* r = work->results;
	scree_query_results list;
	scree_box box = {ray.origin, {ray.origin.x + 4.0f, ray.origin.y + 4.0f}};
	work->failures += scree_world_list_rays(work->world, NULL, &ray, 1, &list) != SCREE_OK;
	r->lists = hash_list(r->lists, &list, 1);
	work->failures +=
	    scree_world_overlap_shape(work->world, &shape, (scree_pose){ray.origin, {1.0f, 0.0f}}, &list) != SCREE_OK;
	r->lists = hash_list(r->lists, &list, 1);
	work->failures += scree_world_overlap_box(work->world, box, &list) != SCREE_OK;
	r->lists = hash_list(r->lists, &list, 1);
	r->listed[k] = list.count;
}

static void read_world(ReaderWork* work)
{
	Results* r = work->results;
	scree_world* world = work->world;
	uint64_t seed = work->seed;
	if (work->reads_first)
		read_bodies(work);
	for (int k = 0; k < SINGLE; ++k)
	{
		scree_ray ray = {.origin = random_vec(&seed, 40.0f, 40.0f), .translation = random_vec(&seed, 20.0f, 20.0f)};
		scree_shape shape = k % 2 ? box_shape(0.3f, 0.1f + 0.01f * (float)(k % 5)) : circle_shape(0.4f);
		scree_probe probe = {.pose = {ray.origin, {1.0f, 0.0f}}};
		work->failures += scree_world_cast_ray(world, ray.origin, ray.translation, &r->single[k]) != SCREE_OK;
		work->failures += scree_world_cast_shape(world, &shape, probe.pose, ray.translation, &r->shapes[k]) != SCREE_OK;
		work->failures += scree_world_find_nearest(world, NULL, &shape, &probe, 1, 5.0f, &r->nearest[k]) != SCREE_OK;
		make_lists(work, k, ray, shape);
	}
	scree_ray rays[BATCH];
	for (int k = 0; k < BATCH; ++k)
		rays[k] = (scree_ray){.origin = random_vec(&seed, 40.0f, 40.0f), .translation = random_vec(&seed, 9.0f, 9.0f)};
	work->failures += scree_world_cast_rays(world, NULL, rays, BATCH, r->batch) != SCREE_OK;
	// more results than a thread sorts itself
	scree_query_results list;
	work->failures += scree_world_list_rays(world, NULL, rays, BATCH, &list) != SCREE_OK;
	r->lists = hash_list(r->lists, &list, BATCH);
	work->failures += scree_world_overlap_box(world, (scree_box){{-50.0f, -50.0f}, {50.0f, 50.0f}}, &list) != SCREE_OK;
	r->lists = hash_list(r->lists, &list, 1);
	// a call that fails
	scree_query_result none;
	work->failures += scree_world_cast_ray(world, (scree_vec){NAN, 0.0f}, (scree_vec){0}, &none) != SCREE_ERROR_INVALID;
	work->failures += !strstr(scree_error(), "scree_world_cast_ray: origin.x is nan");
	if (!work->reads_first)
		read_bodies(work);
}

static THREAD_RESULT reader_main(void* argument)
{
	ReaderWork* work = argument;
	atomic_fetch_sub(work->waiting, 1);
	while (atomic_load(work->waiting) > 0)
		give_core_away();
	read_world(work);
	return THREAD_END;
}

static void fill(scree_world* world, scree_body* bodies)
{
	scree_attribute box = box_attribute(world, 0.5f, 0.5f);
	add_floor(world);
	for (int k = 0; k < BODIES; ++k)
		bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, box, 1.2f * (float)(k % COLUMNS),
		                     0.6f + 1.2f * (float)(k / COLUMNS), 0.0f);
}

static void change(scree_world* world, scree_body* bodies, int round)
{
	if (round % 2)
		OK(scree_body_destroy(world, bodies[round]));
	if (round % 2)
		bodies[round] =
		    add_body(world, SCREE_BODY_DYNAMIC, box_attribute(world, 0.4f, 0.4f), 1.2f * (float)round, 50.0f, 0.0f);
	OK(scree_body_set_pose(world, bodies[round + 1], (scree_pose){{1.2f * (float)round, 60.0f}, {1.0f, 0.0f}}));
	OK(scree_body_set_velocity(world, bodies[round + 2], (scree_velocity){{1.0f, 2.0f}, 3.0f}));
	if (round % 3 == 1)
		run_steps(world, 2);
}

// Lets all readers begin at the same time after a change. Each makes its own queries; then this thread makes the same ones.
static void check_readers(const scree_world_def* def, int rounds)
{
	scree_body bodies[BODIES];
	scree_world* world = create_world(def);
	fill(world, bodies);
	Results* results = calloc(READERS + 1, sizeof *results);
	for (int round = 0; round < rounds; ++round)
	{
		change(world, bodies, round);
		if (round % 4 == 3)
			OK(scree_world_prepare_queries(world));
		ReaderWork work[READERS];
		Thread threads[READERS];
		atomic_int waiting = READERS;
		for (int k = 0; k < READERS; ++k)
		{
			work[k] = (ReaderWork){world, bodies, (uint64_t)(round * READERS + k + 1), k % 2, results + k, &waiting, 0};
			memset(results + k, 0, sizeof *results);
			assert_true(thread_start(&threads[k], reader_main, &work[k]));
		}
		for (int k = 0; k < READERS; ++k)
			thread_join(threads[k]);
		for (int k = 0; k < READERS; ++k)
		{
			assert_int_equal(work[k].failures, 0);
			work[k].results = results + READERS;
			memset(work[k].results, 0, sizeof *results);
			read_world(&work[k]);
			assert_memory_equal(results + k, results + READERS, sizeof *results);
		}
	}
	assert_true(results[0].listed[0] + results[0].listed[1] > 0);
	free(results);
	scree_world_destroy(world);
}

static void test_readers(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	for (def.threads = 1; def.threads <= 4; def.threads *= 2)
		check_readers(&def, quick() ? 6 : 12);
	def.device = "auto";
	def.timings = true;
	check_readers(&def, 4);
}

// The queries of a world with a pool use the calling thread alone, and the functions of the pool are not called.
static void test_readers_beside_a_pool(void** state)
{
	(void)state;
	TaskPool pool;
	pool_open(&pool, POOL_PLAIN, 3);
	scree_tasks tasks = pool_tasks(&pool);
	scree_world_def def = scree_world_def_default();
	def.threads = 4;
	def.tasks = &tasks;
	check_readers(&def, 6);
	scree_body bodies[BODIES];
	scree_world* world = create_world(&def);
	fill(world, bodies);
	int before = pool.enqueued;
	scree_ray rays[BATCH] = {{.translation = {1.0f, 0.0f}}};
	scree_query_result found[BATCH];
	OK(scree_world_cast_rays(world, NULL, rays, BATCH, found));
	assert_int_equal(pool.enqueued, before);
	scree_world_destroy(world);
	pool_close(&pool);
}

static void test_readers_of_another_device(void** state)
{
	(void)state;
	if (scree_opencl_hint()[0] != '\0')
		skip();
	scree_world_def def = scree_world_def_default();
	def.device = "opencl";
	check_readers(&def, 3);
	def.recovery_interval = 2;
	check_readers(&def, 2);
}

static void test_prepare_queries(void** state)
{
	(void)state;
	assert_int_equal(scree_world_prepare_queries(NULL), SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(), "scree_world_prepare_queries: world is null");
	scree_world* world = open_test_world(0.0f);
	OK(scree_world_prepare_queries(world));
	scree_body body = add_body(world, SCREE_BODY_DYNAMIC, box_attribute(world, 0.5f, 0.5f), 5.0f, 0.0f, 0.0f);
	uint64_t hash = hash_of(world);
	OK(scree_world_prepare_queries(world));
	OK(scree_world_prepare_queries(world));
	assert_int_equal(hash_of(world), hash);
	scree_query_result found;
	OK(scree_world_cast_ray(world, (scree_vec){0}, (scree_vec){10.0f, 0.0f}, &found));
	assert_true(found.hit);
	NEAR(found.fraction, 0.45, 1e-6);
	OK(scree_body_set_pose(world, body, (scree_pose){{5.0f, 3.0f}, {1.0f, 0.0f}})); // a change ends the preparation
	OK(scree_world_cast_ray(world, (scree_vec){0}, (scree_vec){10.0f, 0.0f}, &found));
	assert_false(found.hit);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_readers), cmocka_unit_test(test_readers_beside_a_pool),
	                                   cmocka_unit_test(test_readers_of_another_device)};
	const struct CMUnitTest on_devices[] = {cmocka_unit_test(test_prepare_queries)};
	return cmocka_run_group_tests(tests, NULL, memory_is_released) + RUN_ON_DEVICES(on_devices);
}
