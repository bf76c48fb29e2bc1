// SPDX-License-Identifier: MIT
// test_persistent.c -- checks the persistent kernel of OpenCL, and kernels that a work-group computes together,
// compiled as C. A seed decides the order in which work-items run.
//
// Formula: hash(persistent, seed, step) = hash(cpu, step), for each step. If a work-group never runs, all work-items
// end and report the missing work-group.
#include "emulation/emulated_kernels.h"
#include "emulation/emulation_scenes.h"
#include "support/checks.h"

// One work-group needs no barrier with others. If there are several work-groups, the first one executes short runs
// without the others.
static const Form forms[] = {
    {.name = "one group", .persistent = true, .groups = 1},
    {.name = "two groups", .persistent = true, .groups = 2},
    {.name = "five groups, ahead", .persistent = true, .groups = 5, .ahead = true},
};

static void all_runs_are_equal(void** state)
{
	(void)state;
	int launches = 0, runs = 0, group_stages = 0;
	for (int k = 0; k < (int)(sizeof forms / sizeof *forms); ++k)
		for (int scene = 0; scene < form_scene_count; ++scene)
			for (int seed = 1; seed <= form_seeds(k, scene); ++seed)
			{
				Form form = forms[k];
				form.schedule.seed = 1000003u * (uint64_t)seed + (uint64_t)k;
				check_form(&form_scenes[scene], &form);
				launches += form_counts.launches;
				runs += form_counts.runs;
				group_stages += form_counts.group_stages;
			}
	assert_true(runs > 8 * launches && launches > 0 && group_stages > 0);
}

// If one work-group never runs, the others stay at the next barrier until they give up.
static void groups_that_stay_away_are_found(void** state)
{
	(void)state;
	for (int group = 1; group <= 3; ++group)
		check_fault("pyramid",
		            (Form){.name = "persistent", .persistent = true, .groups = 3, .schedule.shunned = group});
}

int main(void)
{
	int refused = check_refused();
	const struct CMUnitTest tests[] = {cmocka_unit_test(all_runs_are_equal),
	                                   cmocka_unit_test(groups_that_stay_away_are_found)};
	return refused ? refused : cmocka_run_group_tests(tests, NULL, NULL);
}
