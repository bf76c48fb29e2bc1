// SPDX-License-Identifier: MIT
// test_threads.c -- workers: every one runs once a region, and a barrier separates what is before from what is after.
#include "platform/error.h"
#include "platform/threads.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static const int worker_counts[] = {1, 2, 3, 8};
#define WORKER_COUNTS (int)(sizeof(worker_counts) / sizeof(worker_counts[0]))
#define REGIONS       1000
#define ROUNDS        50

typedef struct
{
	Threads* threads;
	int runs[MAX_WORKERS]; // plain ints: a missing barrier is a data race that the thread sanitizer sees
	int values[MAX_WORKERS];
	int wrong[MAX_WORKERS];
	int alone;
} Scene;

static void with_workers(void test(Scene* scene, int workers))
{
	for (int i = 0; i < WORKER_COUNTS; ++i)
	{
		Scene scene = {.threads = threads_open(worker_counts[i])};
		assert_non_null(scene.threads);
		assert_int_equal(threads_workers(scene.threads), worker_counts[i]);
		test(&scene, worker_counts[i]);
		threads_close(scene.threads);
	}
}

static void run_once(void* context, int worker, int workers)
{
	Scene* scene = context;
	scene->wrong[worker] += workers != threads_workers(scene->threads);
	++scene->runs[worker];
}

static void check_regions(Scene* scene, int workers)
{
	for (int region = 1; region <= REGIONS; ++region)
	{
		threads_run(scene->threads, run_once, scene);
		for (int worker = 0; worker < MAX_WORKERS; ++worker)
			assert_int_equal(scene->runs[worker], worker < workers ? region : 0);
	}
	for (int worker = 0; worker < workers; ++worker)
		assert_int_equal(scene->wrong[worker], 0);
}

static void test_every_worker_runs_once_a_region(void** state)
{
	(void)state;
	with_workers(check_regions);
}

// each writes its own value and reads those of the others
static void exchange(void* context, int worker, int workers)
{
	Scene* scene = context;
	for (int round = 1; round <= ROUNDS; ++round)
	{
		scene->values[worker] = round * (worker + 1);
		threads_barrier(scene->threads);
		for (int other = 0; other < workers; ++other)
			scene->wrong[worker] += scene->values[other] != round * (other + 1);
		threads_barrier(scene->threads);
	}
}

static void check_barriers(Scene* scene, int workers)
{
	for (int region = 0; region < REGIONS / ROUNDS; ++region)
		threads_run(scene->threads, exchange, scene);
	for (int worker = 0; worker < workers; ++worker)
		assert_int_equal(scene->wrong[worker], 0);
}

static void test_barrier_separates(void** state)
{
	(void)state;
	with_workers(check_barriers);
}

// one worker a round is told to go ahead while the others wait
static void take_turns(void* context, int worker, int workers)
{
	Scene* scene = context;
	(void)workers;
	for (int round = 1; round <= ROUNDS; ++round)
	{
		if (threads_gather(scene->threads, worker))
		{
			++scene->alone;
			++scene->runs[worker];
			threads_release(scene->threads);
		}
		scene->wrong[worker] += scene->alone != round;
		threads_barrier(scene->threads);
	}
}

static void check_turns(Scene* scene, int workers)
{
	for (int region = 0; region < REGIONS / ROUNDS; ++region)
	{
		scene->alone = 0;
		memset(scene->runs, 0, sizeof(scene->runs));
		threads_run(scene->threads, take_turns, scene);
		int turns = 0;
		for (int worker = 0; worker < workers; ++worker)
		{
			turns += scene->runs[worker];
			assert_int_equal(scene->wrong[worker], 0);
		}
		assert_int_equal(turns, ROUNDS);
	}
}

static void test_one_worker_acts_alone(void** state)
{
	(void)state;
	with_workers(check_turns);
}

// worker 0 comes so late that the others have gone to sleep, at the barrier and between regions
static void come_late(void* context, int worker, int workers)
{
	Scene* scene = context;
	(void)workers;
	volatile uint64_t spin = 0;
	if (worker == 0)
		while (spin < 3000000)
			++spin;
	threads_barrier(scene->threads);
	++scene->runs[worker];
}

static void check_sleepers(Scene* scene, int workers)
{
	for (int region = 1; region <= 5; ++region)
	{
		volatile uint64_t spin = 0;
		while (spin < 3000000)
			++spin;
		threads_run(scene->threads, come_late, scene);
		for (int worker = 0; worker < workers; ++worker)
			assert_int_equal(scene->runs[worker], region);
	}
}

static void test_sleepers_wake(void** state)
{
	(void)state;
	with_workers(check_sleepers);
}

static void test_open_and_close_leave_nothing(void** state)
{
	(void)state;
	size_t before = scree_memory();
	for (int i = 0; i < 50; ++i)
		threads_close(threads_open(i % 4 + 1));
	threads_close(NULL);
	assert_int_equal(scree_memory(), before);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_every_worker_runs_once_a_region), cmocka_unit_test(test_barrier_separates),
	    cmocka_unit_test(test_one_worker_acts_alone),           cmocka_unit_test(test_sleepers_wake),
	    cmocka_unit_test(test_open_and_close_leave_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
