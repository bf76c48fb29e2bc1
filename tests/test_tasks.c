// SPDX-License-Identifier: MIT
// test_tasks.c -- checks worlds whose work is done by threads of the program: bits, threads, pools of every kind.
#include "support/make_bodies.h"
#include "support/task_pool.h"
#include "support/variants.h"
#ifdef __linux__
#include <dirent.h>
#endif

#define COLUMNS 40
#define ROWS    40
#define STEPS   (quick() ? 20 : 60)

// Returns the number of threads of the process, or -1 on a system that does not list them.
static int threads_of_process(void)
{
#ifdef __linux__
	DIR* folder = opendir("/proc/self/task");
	if (!folder)
		return -1;
	int count = 0;
	for (const struct dirent* entry; (entry = readdir(folder));)
		count += entry->d_name[0] != '.';
	closedir(folder);
	return count;
#else
	return -1;
#endif
}

static void fill(scree_world* world)
{
	scree_attribute box = box_attribute(world, 0.5f, 0.5f);
	add_floor(world);
	for (int k = 0; k < ROWS * COLUMNS; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, box, 1.1f * (float)(k % COLUMNS) + 0.1f * (float)(k / COLUMNS % 3),
		         0.6f + 1.1f * (float)(k / COLUMNS), 0.0f);
}

static uint64_t hash_after_steps(const scree_world_def* def)
{
	scree_world* world = create_world(def);
	fill(world);
	run_steps(world, STEPS);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	return hash;
}

static scree_world_def cpu_def(int threads)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = threads;
	return def;
}

// A world that a pool steps has the bits of one with threads of the library, for pools that run the tasks at the same time, one
// after another, on the calling thread, late, or never; also with fewer threads than the world has.
static void test_every_pool_gives_the_same_bits(void** state)
{
	(void)state;
	scree_world_def def = cpu_def(4);
	uint64_t expected = hash_after_steps(&def);
	for (int kind = 0; kind < POOL_KINDS; ++kind)
	{
		for (int threads = 1; threads <= 3; threads += 2)
		{
			TaskPool pool;
			pool_open(&pool, (PoolKind)kind, threads);
			scree_tasks tasks = pool_tasks(&pool);
			def.tasks = &tasks;
			for (def.threads = 0; def.threads <= 16; def.threads = def.threads ? 4 * def.threads : 1)
			{
				uint64_t hash = hash_after_steps(&def);
				if (hash != expected)
					fail_msg("pool %d with %d threads, a world with %d: another hash", kind, threads, def.threads);
			}
			assert_true(pool.enqueued > 0);
			bool null = kind == POOL_AT_ONCE || kind == POOL_REFUSING;
			assert_int_equal(pool.finished, null ? 0 : pool.enqueued);
			assert_null(pool.task);
			pool_close(&pool);
		}
	}
}

// The threads of a plain pool process blocks: an enqueued task is called once for each worker but the caller.
static void test_tasks_are_called_once_for_each_worker(void** state)
{
	(void)state;
	TaskPool pool;
	pool_open(&pool, POOL_PLAIN, 3);
	scree_tasks tasks = pool_tasks(&pool);
	scree_world_def def = cpu_def(4);
	def.tasks = &tasks;
	hash_after_steps(&def);
	assert_int_equal(pool.calls, 3 * pool.enqueued);
	pool_close(&pool);
}

// With a pool, and with one thread, the library starts no thread; without, it starts `threads` - 1. "auto" starts none either.
static void test_no_thread_is_started(void** state)
{
	(void)state;
	if (threads_of_process() < 0)
		skip();
	TaskPool pool;
	pool_open(&pool, POOL_PLAIN, 3);
	scree_tasks tasks = pool_tasks(&pool);
	int before = threads_of_process();
	scree_world_def def = cpu_def(4);
	for (int k = 0; k < 4; ++k)
	{
		def.tasks = k == 0 || k == 3 ? &tasks : NULL;
		def.threads = k == 1 ? 1 : 4;
		def.device = k == 3 ? "auto" : "cpu";
		scree_world* world = create_world(&def);
		fill(world);
		run_steps(world, 10);
		assert_int_equal(threads_of_process() - before, k == 2 ? 3 : 0);
		assert_string_equal(scree_world_get_device(world), "cpu");
		assert_int_equal(scree_world_get_threads(world), def.threads);
		scree_world_destroy(world);
	}
	pool_close(&pool);
}

// The definition may end before the world; clones and restored worlds have the pool too.
static void test_the_pool_stays_with_the_world(void** state)
{
	(void)state;
	TaskPool pool;
	pool_open(&pool, POOL_LATE, 0);
	scree_tasks tasks = pool_tasks(&pool);
	scree_world_def def = cpu_def(4);
	uint64_t expected = hash_after_steps(&def);
	def.tasks = &tasks;
	scree_world *world = create_world(&def), *clone;
	tasks = (scree_tasks){0};
	fill(world);
	const void* bytes;
	size_t size;
	OK(scree_world_snapshot(world, &bytes, &size));
	OK(scree_world_restore(world, bytes, size));
	OK(scree_world_clone(world, NULL, &clone));
	int before = pool.enqueued;
	run_steps(world, STEPS);
	assert_true(pool.enqueued > before);
	before = pool.enqueued;
	run_steps(clone, STEPS);
	assert_true(pool.enqueued > before);
	assert_int_equal(hash_of(world), expected);
	assert_int_equal(hash_of(clone), expected);
	scree_world_destroy(clone);
	scree_world_destroy(world);
	pool_close(&pool);
}

// A world on an OpenCL device, which needs the pool for transfers at most, has the same bits; it can move to the CPU and back. Device
// "auto" is the CPU.
static void test_other_devices(void** state)
{
	(void)state;
	if (scree_opencl_hint()[0] != '\0')
		skip();
	TaskPool pool;
	pool_open(&pool, POOL_PLAIN, 2);
	scree_tasks tasks = pool_tasks(&pool);
	scree_world_def def = cpu_def(3);
	uint64_t expected = hash_after_steps(&def);
	def.device = "opencl";
	def.tasks = &tasks;
	scree_world* world = create_world(&def);
	fill(world);
	run_steps(world, STEPS / 2);
	OK(scree_world_move(world, "cpu"));
	OK(scree_world_move(world, "opencl"));
	assert_string_not_equal(scree_world_get_device(world), "cpu");
	OK(scree_world_move(world, "auto"));
	assert_string_equal(scree_world_get_device(world), "cpu");
	run_steps(world, STEPS - STEPS / 2);
	assert_true(pool.enqueued > 0);
	assert_int_equal(hash_of(world), expected);
	scree_world_destroy(world);
	pool_close(&pool);
}

static void check_refused(scree_tasks tasks, const char* sentence)
{
	scree_world_def def = cpu_def(2);
	scree_world* world = NULL;
	def.tasks = &tasks;
	assert_int_equal(scree_world_create(&def, &world), SCREE_ERROR_INVALID);
	assert_null(world);
	assert_string_equal(scree_error(), sentence);
}

static void test_both_functions_must_be_set(void** state)
{
	(void)state;
	TaskPool pool;
	pool_open(&pool, POOL_AT_ONCE, 0);
	scree_tasks tasks = pool_tasks(&pool);
	check_refused((scree_tasks){0}, "scree_world_create: def.tasks has no enqueue");
	check_refused((scree_tasks){.finish = tasks.finish}, "scree_world_create: def.tasks has no enqueue");
	check_refused((scree_tasks){.enqueue = tasks.enqueue}, "scree_world_create: def.tasks has no finish");
	pool_close(&pool);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_every_pool_gives_the_same_bits),
	    cmocka_unit_test(test_tasks_are_called_once_for_each_worker),
	    cmocka_unit_test(test_no_thread_is_started),
	    cmocka_unit_test(test_the_pool_stays_with_the_world),
	    cmocka_unit_test(test_other_devices),
	    cmocka_unit_test(test_both_functions_must_be_set),
	};
	return cmocka_run_group_tests(tests, NULL, memory_is_released);
}
