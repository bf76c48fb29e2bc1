// SPDX-License-Identifier: MIT
// test_programs.c -- checks that random programs of calls have equal bits and a finite state on every device, with
// every number of lanes and threads.
//
// Formula: status(device) = status(cpu, 1 thread, 1 lane) after each call, and the same for results and hashes.
// bench/programs.sh runs thousands of programs on a GPU. build/tests/programs --help lists the options with which a
// program is run again, or other programs are run.
#include "platform/processor.h"
#include "programs/program.h"
#include "support/variants.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// first seed; a failure prints the seed of its program
#define FIRST_SEED 1000

static int hide_log(void** state)
{
	(void)state;
	return pair_hide_log() != SCREE_OK;
}

// Shortens a failed program, and prints the shorter program with a description of its failure.
static void print_failure(Pair* pair, Program* program, const Variant* variant, uint64_t seed)
{
	program_shrink(program, pair, 20.0);
	pair_forget(pair);
	Outcome outcome = pair_run(pair, program, stderr);
	print_error("%s, program %llu, after call %d: %s\n", variant->name, (unsigned long long)seed, outcome.call,
	            outcome.differs ? outcome.sentence : "differed, and does not when run again");
	program_write(program, stderr);
}

// second: the place of the second world, except for its devices, threads and lanes.
static void check_variant(const Variant* variant, int count, Place second)
{
	Place places[2] = {{.device = "cpu", .threads = 1, .lanes = 1}, second};
	places[1].threads = variant->threads;
	places[1].lanes = variant->lanes;
	snprintf(places[1].device, sizeof places[1].device, "%s", variant->device);
	if (variant->other[0])
		snprintf(places[1].other, sizeof places[1].other, "%s", variant->other);
	Pair pair;
	Program program = {0};
	solve_form_setting = variant->form;
	pair_open(&pair, places);
	pair.records = true;
	bool differs = false;
	for (int k = 0; k < count && !differs; ++k)
	{
		uint64_t seed = FIRST_SEED + (uint64_t)k;
		program_make(&program, seed, 200);
		differs = pair_run(&pair, &program, NULL).differs;
		if (differs)
			print_failure(&pair, &program, variant, seed);
	}
	pair_close(&pair);
	program_close(&program);
	solve_form_setting = FORM_ANY;
	if (differs)
		fail_msg("a program of calls left other bits: %s", variant->name);
}

static void programs_are_equal(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 1; k < count; ++k)
		check_variant(&variants[k],
		              strcmp(variants[k].device, "cpu") == 0 && !variants[k].other[0] ? (quick() ? 12 : 48)
		              : quick()                                                       ? 4
		                                                                              : 24,
		              (Place){.reads = false});
}

// Checks that reads between calls do not change the bits of a world.
static void reads_change_nothing(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	list_variants(variants);
	check_variant(&variants[0], quick() ? 50 : 400, (Place){.reads = true});
}

// Checks that copies of a world in a batch, made after each step, go on with its bits.
static void batches_are_equal(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	for (int k = 0; k < count; ++k)
		if (strcmp(variants[k].device, "cpu") == 0 && !variants[k].other[0] &&
		    (variants[k].lanes == processor_widest_lanes() || (k == 0 && !quick())))
			check_variant(&variants[k], quick() ? 1 : 4, (Place){.batches = true});
}

// Checks that a world whose device fails between calls goes on with the same bits (docs/manual/faults.md).
static void failures_change_nothing(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	list_variants(variants);
	check_variant(&variants[0], quick() ? 50 : 300, (Place){.faults = true});
}

// Checks that devices that flush denormals to 0 leave the same bits (docs/design/determinism.md).
static void denormals_change_nothing(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	list_variants(variants);
	check_variant(&variants[0], quick() ? 100 : 1000, (Place){.flush = true});
}

typedef struct // program of the folder saved, and the difference of its second world on which its bits once depended
{
	const char* name;
	bool flushes;
} Saved;

static const Saved saved[] = {
    {"tiles_leave", false},   {"press_ends", false},        {"shape_of_a_lift", false}, {"gear_shifts", false},
    {"joint_slot", false},    {"spring_share", true},       {"heavy_chain", true},      {"strong_drag", true},
    {"slow_bounce", true},    {"heavy_joint", true},        {"tiny_report", true},      {"same_place", true},
    {"fast_body", true},      {"infinite_drag", true},      {"far_anchor", true},       {"heavy_link", true},
    {"branch_pivot", true},   {"tiny_gap", true},           {"tiny_share", true},       {"moved_anchor", false},
    {"woken_gap", false},     {"destroyed_sleeper", false}, {"pressed_sleeper", false}, {"joined_sleepers", false},
    {"moved_frames", false},  {"one_way_sleepers", false},  {"sleep_lengths", false},   {"tiny_threshold", true},
    {"changed_shape", false}, {"belts_grow", false},        {"paused_taut", false},
};

// Runs saved programs with several choices of reads, or with flushed denormals.
static void saved_programs_are_equal(void** state)
{
	(void)state;
	for (size_t k = 0; k < sizeof saved / sizeof saved[0]; ++k)
	{
		char path[1024], error[256] = "";
		Program program = {0};
		const char* source = getenv("SCREE_SOURCE");
		Place places[2] = {{.device = "cpu", .threads = 1, .lanes = 1},
		                   {.device = "cpu", .reads = !saved[k].flushes, .flush = saved[k].flushes}};
		snprintf(path, sizeof path, "%s/tests/programs/saved/%s.txt", source ? source : ".", saved[k].name);
		FILE* file = fopen(path, "r");
		if (!file || !program_read(&program, file, error))
			fail_msg("%s: %s", path, file ? error : "cannot be opened");
		fclose(file);
		Pair pair;
		pair_open(&pair, places);
		for (; pair.first_read < (saved[k].flushes ? 1 : READ_CHOICES); ++pair.first_read)
		{
			Outcome outcome = pair_run(&pair, &program, stderr);
			if (outcome.differs)
				fail_msg("%s, reads from %u on, after call %d: %s", saved[k].name, (unsigned)pair.first_read,
				         outcome.call, outcome.sentence);
		}
		pair_close(&pair);
		program_close(&program);
	}
}

// Checks that a program does not change when it is written as text and read again.
static void text_is_the_program(void** state)
{
	(void)state;
	Program made = {0}, read = {0};
	char error[256] = "";
	program_make(&made, 7, 200);
	FILE* file = tmpfile();
	assert_non_null(file);
	program_write(&made, file);
	rewind(file);
	if (!program_read(&read, file, error))
		fail_msg("%s", error);
	fclose(file);
	assert_int_equal(read.count, made.count);
	for (int k = 0; k < made.count; ++k)
	{
		assert_int_equal(read.calls[k].kind, made.calls[k].kind);
		for (int i = 0; i < call_info(made.calls[k].kind)->count; ++i)
			if (made.calls[k].value[i] == made.calls[k].value[i]) // skips NaN, whose text lacks some bits
				assert_memory_equal(&read.calls[k].value[i], &made.calls[k].value[i], sizeof(float));
	}
	program_close(&made);
	program_close(&read);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(text_is_the_program),      cmocka_unit_test(programs_are_equal),
	    cmocka_unit_test(reads_change_nothing),     cmocka_unit_test(batches_are_equal),
	    cmocka_unit_test(failures_change_nothing),  cmocka_unit_test(denormals_change_nothing),
	    cmocka_unit_test(saved_programs_are_equal),
	};
	return cmocka_run_group_tests(tests, hide_log, NULL);
}
