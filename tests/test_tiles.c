// SPDX-License-Identifier: MIT
// test_tiles.c -- checks the tiles of OpenCL, compiled as C with 16 bodies per tile. A seed decides the order in which
// work-items take turns.
//
// Formula: hash(tiles, seed, step) = hash(cpu, step) for each step, and all words of mailboxes are 0 after a solve. If
// a work-item at the border of a tile never gets a turn, all others end with a fault.
#include "emulation/emulation_scenes.h"
#include "support/checks.h"

static const Form forms[] = {
    {.name = "tiles", .tiles = true, .groups = 8},
    {.name = "tiles, few groups, late words", .tiles = true, .groups = 2, .schedule = {.late = true, .pieces = 8}},
    {.name = "tiles, ahead", .tiles = true, .groups = 4, .ahead = true, .schedule.late = true},
};

static void tiles_are_equal(void** state)
{
	(void)state;
	int tiles = 0, inner = 0, border = 0, kept = 0;
	for (size_t k = 0; k < sizeof forms / sizeof *forms; ++k)
		for (int scene = 0; scene < form_scene_count; ++scene)
			for (int seed = 1; seed <= form_seeds((int)k, scene) && !form_scenes[scene].hubs; ++seed)
			{
				Form form = forms[k];
				form.schedule.seed = 1000033u * (uint64_t)seed + k;
				check_form(&form_scenes[scene], &form);
				kept += form_counts.kept;
				tiles = form_counts.tiles > tiles ? form_counts.tiles : tiles;
				inner = form_counts.inner > inner ? form_counts.inner : inner;
				border = form_counts.border > border ? form_counts.border : border;
			}
	assert_true(tiles > 3 && inner > 32 && border > 128 && kept > 10);
}

static void shunned_groups_are_found(void** state)
{
	(void)state;
	for (int group = 1; group <= 4; ++group)
		check_fault("pyramid", (Form){.name = "tiles", .tiles = true, .groups = 4, .schedule.shunned = group});
}

static void lost_words_are_found(void** state)
{
	(void)state;
	check_lost("pyramid", (Form){.name = "tiles", .tiles = true, .groups = 3});
	check_lost("joints", (Form){.name = "tiles, joints", .tiles = true, .groups = 3});
	check_lost("heap", (Form){.name = "tiles, late words", .tiles = true, .groups = 8, .schedule.late = true});
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(tiles_are_equal),
	    cmocka_unit_test(shunned_groups_are_found),
	    cmocka_unit_test(lost_words_are_found),
	};
	int refused = check_refused();
	return refused ? refused : cmocka_run_group_tests(tests, NULL, NULL);
}
