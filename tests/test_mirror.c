// SPDX-License-Identifier: MIT
// test_mirror.c -- checks that hostile worlds in batches stay equal to the same worlds alone, through random calls.
//
// Formula: hash, counters and outputs of a world of a batch = those of the same world alone, after each call. A failure prints the
// seed of its run; build/tests/mirror --help lists the options with which it is run again, or other seeds are run.
#include "mirror/mirrored.h"
#include "programs/program.h"
#include "support/second_device.h"

// first seed
#define FIRST_SEED 1000

// Runs seeds, and returns the sum of the hashes.
static uint64_t run_seeds(Setting setting, int count)
{
	Counts counts = {.seeds = 0};
	for (int k = 0; k < count; ++k)
		mirror_run(&setting, FIRST_SEED + (uint64_t)k, &counts);
	assert_int_equal(counts.faults, 0);
	assert_true(counts.ended < counts.seeds && counts.compared > counts.steps);
	return counts.hash;
}

static void worlds_are_equal(void** state)
{
	(void)state;
	run_seeds((Setting){.device = "cpu"}, quick() ? 24 : 200);
}

static void lanes_are_equal(void** state)
{
	(void)state;
	uint64_t one = run_seeds((Setting){.device = "cpu", .lanes = 1}, quick() ? 4 : 20);
	assert_true(run_seeds((Setting){.device = "cpu"}, quick() ? 4 : 20) == one);
}

static void devices_are_equal(void** state)
{
	(void)state;
	NEEDS_SECOND_DEVICE();
	int count = quick() ? 3 : 20;
	scree_batch* kept;
	OK(batch_keep(second_device, &kept));
	uint64_t hash = run_seeds((Setting){.device = second_device}, count);
	scree_batch_destroy(kept);
	assert_true(hash == run_seeds((Setting){.device = "cpu"}, count));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(worlds_are_equal),
	    cmocka_unit_test(lanes_are_equal),
	    cmocka_unit_test(devices_are_equal),
	};
	find_second_device(NULL);
	if (pair_hide_log() != SCREE_OK)
		return 1;
	return cmocka_run_group_tests(tests, NULL, NULL);
}
