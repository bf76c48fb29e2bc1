// SPDX-License-Identifier: MIT
// test_golden.c -- checks the hash of every scene against tests/golden.txt, which holds for every compiler and machine.
//
// After an intended change of bits, SCREE_GOLDEN=write ctest -R test_golden writes tests/golden.txt again, and
// CHANGELOG.md gives the reason. The smaller set of tests takes a quarter of the steps; the file also has the hashes
// after these steps.
#include "support/small_scenes.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HEADING "# scene, steps, hash: written by test_golden.c; a changed line is explained in CHANGELOG.md\n"

typedef struct
{
	char scene[64];
	int steps;
	uint64_t hash;
} Golden;

static Golden computed[96], committed[96];
static int computed_count, committed_count;

// Adds two hashes of a scene to `computed`: after a quarter of its steps, and at the end. The smaller set of tests
// takes only the first quarter, so it adds one hash.
static void compute(const Scenario* scenario)
{
	Variant variant = {.name = "cpu", .device = "cpu"};
	uint64_t* hashes = calloc((size_t)scenario->steps, sizeof *hashes);
	record(scenario, &variant, hashes, NULL);
	int checks[2] = {quick() ? scenario->steps : scenario->steps / 4, scenario->steps};
	for (int k = quick(); k < 2; ++k)
	{
		Golden* g = computed + computed_count++;
		snprintf(g->scene, sizeof g->scene, "%s", scenario->name);
		g->steps = checks[k];
		g->hash = hashes[checks[k] - 1];
	}
	free(hashes);
}

static void golden_path(char* path, size_t size)
{
	const char* source = getenv("SCREE_SOURCE");
	if (!source)
		fail_msg("SCREE_SOURCE is not set: ctest does that");
	snprintf(path, size, "%s/tests/golden.txt", source);
}

static void write_golden(const char* path)
{
	if (quick())
		fail_msg("only the whole set of tests writes golden hashes");
	FILE* file = fopen(path, "w");
	assert_non_null(file);
	fputs(HEADING, file);
	for (int k = 0; k < computed_count; ++k)
		fprintf(file, "%s %d %016" PRIx64 "\n", computed[k].scene, computed[k].steps, computed[k].hash);
	assert_int_equal(fclose(file), 0);
}

static void read_golden(const char* path)
{
	FILE* file = fopen(path, "r");
	if (!file)
		fail_msg("%s cannot be read", path);
	char line[256];
	while (fgets(line, sizeof line, file))
	{
		Golden* g = committed + committed_count;
		if (line[0] == '#')
			continue;
		if (sscanf(line, "%63s %d %" SCNx64, g->scene, &g->steps, &g->hash) != 3)
			fail_msg("%s: bad line: %s", path, line);
		++committed_count;
	}
	fclose(file);
}

static void hashes_are_golden(void** state)
{
	(void)state;
	char path[1024];
	golden_path(path, sizeof path);
	for_every_scene(compute);
	const char* golden = getenv("SCREE_GOLDEN");
	if (golden && strcmp(golden, "write") == 0)
		write_golden(path);

	read_golden(path);
	int wrong = 0;
	for (int k = 0; k < computed_count; ++k)
	{
		const Golden *g = computed + k, *found = NULL;
		for (int i = 0; i < committed_count; ++i)
			if (strcmp(committed[i].scene, g->scene) == 0 && committed[i].steps == g->steps)
				found = committed + i;
		if (found && found->hash == g->hash)
			continue;
		++wrong;
		print_error("%s after %d steps: %016" PRIx64 ", committed is %016" PRIx64 "\n", g->scene, g->steps, g->hash,
		            found ? found->hash : 0);
	}
	if (wrong > 0)
		fail_msg("%d hashes changed; the head of this file says what to do", wrong);
	if (!quick())
		assert_int_equal(committed_count, computed_count);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(hashes_are_golden)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
