// SPDX-License-Identifier: MIT
// test_threads.c -- checks workers: each block of a job runs once, and reads the values that the previous job wrote.
#include "platform/threads.h"
#include "support/checks.h"
#include <string.h>

static const int worker_counts[] = {1, 2, 3, 8};
#define WORKER_COUNTS (int)(sizeof(worker_counts) / sizeof(worker_counts[0]))
#define JOBS          1000

typedef struct
{
	Threads* threads;
	// calls for each block; plain ints, so that the sanitizer reports a data race if two workers run one block
	int runs[MAX_WORKERS];
	int values[MAX_WORKERS];
	int wrong[MAX_WORKERS];
	int job;
} Scene;

static void with_workers(void test(Scene* scene, int workers))
{
	for (int i = 0; i < WORKER_COUNTS; ++i)
	{
		Scene scene = {.threads = threads_open(worker_counts[i], NULL)};
		assert_non_null(scene.threads);
		assert_int_equal(threads_workers(scene.threads), worker_counts[i]);
		test(&scene, worker_counts[i]);
		for (int block = 0; block < MAX_WORKERS; ++block)
			assert_int_equal(scene.wrong[block], 0);
		threads_close(scene.threads);
	}
}

static void spend(int rounds)
{
	for (volatile int k = 0; k < rounds; ++k)
		;
}

static void count_run(void* context, int block, int blocks)
{
	Scene* scene = context;
	scene->wrong[block] += block < 0 || block >= blocks;
	++scene->runs[block];
}

// Runs jobs with every number of blocks, with workers awake or asleep, and checks that each block runs once.
static void check_runs(Scene* scene, int workers)
{
	int expected[MAX_WORKERS] = {0};
	for (int job = 0; job < JOBS; ++job)
	{
		int blocks = 1 + job % workers;
		if (job % 50 == 0)
			threads_begin(scene->threads);
		if (job % 50 == 25)
			threads_end(scene->threads);
		threads_run(scene->threads, count_run, scene, blocks);
		for (int block = 0; block < MAX_WORKERS; ++block)
		{
			expected[block] += block < blocks;
			assert_int_equal(scene->runs[block], expected[block]);
		}
	}
	threads_end(scene->threads);
	threads_run_once(scene->threads, count_run, scene);
	for (int block = 0; block < workers; ++block)
		assert_int_equal(scene->runs[block], expected[block] + 1);
}

static void test_every_block_runs_once(void** state)
{
	(void)state;
	with_workers(check_runs);
}

// Writes the value of a block. In the next job each block reads the values of all blocks.
static void write_value(void* context, int block, int blocks)
{
	Scene* scene = context;
	(void)blocks;
	scene->values[block] = scene->job * (block + 1);
}

static void read_values(void* context, int block, int blocks)
{
	Scene* scene = context;
	for (int other = 0; other < blocks; ++other)
		scene->wrong[block] += scene->values[other] != scene->job * (other + 1);
}

static void check_order(Scene* scene, int workers)
{
	threads_begin(scene->threads);
	for (scene->job = 1; scene->job <= JOBS; ++scene->job)
	{
		threads_run(scene->threads, write_value, scene, workers);
		threads_run(scene->threads, read_values, scene, workers);
	}
	threads_end(scene->threads);
}

static void test_a_job_follows_the_one_before(void** state)
{
	(void)state;
	with_workers(check_order);
}

// Runs jobs after pauses in which workers fall asleep. Each job must be complete, whether workers wake up or not.
static void check_sleepers(Scene* scene, int workers)
{
	for (int job = 1; job <= 10; ++job)
	{
		spend(3000000);
		if (job % 2)
			threads_run_once(scene->threads, count_run, scene);
		else
			threads_run(scene->threads, count_run, scene, workers);
		for (int block = 0; block < workers; ++block)
			assert_int_equal(scene->runs[block], job);
	}
}

static void test_sleepers_delay_nobody(void** state)
{
	(void)state;
	with_workers(check_sleepers);
}

// Spends a long time in one block of a job. The job must last until this block is done, and late workers must not claim
// blocks of the next job.
static void take_long(void* context, int block, int blocks)
{
	Scene* scene = context;
	if (block == scene->job % blocks)
		spend(100000);
	++scene->runs[block];
}

static void check_long(Scene* scene, int workers)
{
	threads_begin(scene->threads);
	for (scene->job = 1; scene->job <= 100; ++scene->job)
	{
		threads_run(scene->threads, take_long, scene, workers);
		for (int block = 0; block < workers; ++block)
			assert_int_equal(scene->runs[block], scene->job);
	}
	threads_end(scene->threads);
}

static void test_a_job_waits_for_its_last_block(void** state)
{
	(void)state;
	with_workers(check_long);
}

static void test_open_and_close_leave_nothing(void** state)
{
	(void)state;
	size_t before = scree_memory();
	for (int i = 0; i < 50; ++i)
		threads_close(threads_open(i % 4 + 1, NULL));
	threads_close(NULL);
	assert_int_equal(scree_memory(), before);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_every_block_runs_once),        cmocka_unit_test(test_a_job_follows_the_one_before),
	    cmocka_unit_test(test_sleepers_delay_nobody),        cmocka_unit_test(test_a_job_waits_for_its_last_block),
	    cmocka_unit_test(test_open_and_close_leave_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
