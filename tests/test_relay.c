// SPDX-License-Identifier: MIT
// test_relay.c -- checks the relay of OpenCL, compiled as C. A seed decides the order in which work-items take turns.
//
// Formula: hash(relay, seed, step) = hash(cpu, step) for each step, and all words of mailboxes are 0 after a solve. If
// one work-item never gets a turn, all others end with a fault.
#include "emulation/emulated_kernels.h"
#include "emulation/emulation_scenes.h"
#include "support/make_worlds.h"
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// equal bits
// ---------------------------------------------------------------------------------------------------------------

// Emulated variants of the relay. Registers: all constraints fit into registers; streamed: they do not. Late words:
// writes to mailboxes arrive some time later, 8 bytes at once. Ahead: the solve is listed before the host has read the
// number of its constraints. Spread: up to 8 work-items per constraint.
static const Form plain_forms[] = {
    {.name = "registers", .groups = 16},
    {.name = "streamed", .groups = 3, .schedule = {.late = true, .pieces = 8}},
    {.name = "registers, late words, ahead", .groups = 16, .ahead = true, .schedule = {.late = true, .pieces = 8}},
    {.name = "streamed, one group", .groups = 1},
    {.name = "spread", .groups = 16, .most_spread = 8, .schedule = {.leavers = true, .late = true}},
};

static const Form hub_forms[] = {
    {.name = "hubs, registers", .groups = 12, .group = 32, .hub_groups = 2},
    {.name = "hubs, streamed, late words",
     .groups = 4,
     .group = 48,
     .hub_groups = 3,
     .schedule = {.late = true, .pieces = 8}},
    {.name = "hubs, one group", .groups = 1, .group = 64, .schedule = {.late = true}},
    {.name = "hubs, spread, ahead", .groups = 4, .group = 256, .hub_groups = 2, .most_spread = 8, .ahead = true},
};

// Runs each variant on each scene. Returns the sums of the counters, but the maximum of `spread`. By these values the
// caller checks that all cases occurred.
static FormCounts check_forms(const Form* forms, int count, bool hubs)
{
	FormCounts sum = {0};
	for (int k = 0; k < count; ++k)
		for (int scene = 0; scene < form_scene_count; ++scene)
			for (int seed = 1; seed <= form_seeds(k, scene) && form_scenes[scene].hubs == hubs; ++seed)
			{
				Form form = forms[k];
				form.schedule.seed = 1000003u * (uint64_t)seed + (uint64_t)k;
				check_form(&form_scenes[scene], &form);
				sum.solves += form_counts.solves;
				sum.by_hubs += form_counts.by_hubs;
				sum.split += form_counts.split;
				sum.registers += form_counts.registers;
				sum.streamed += form_counts.streamed;
				sum.spread = form_counts.spread > sum.spread ? form_counts.spread : sum.spread;
			}
	return sum;
}

static void relays_are_equal(void** state)
{
	(void)state;
	FormCounts sum = check_forms(plain_forms, sizeof plain_forms / sizeof *plain_forms, false);
	assert_true(sum.registers > 0 && sum.streamed > 0 && sum.by_hubs == 0);
	assert_int_equal(sum.spread, 8);
}

static void relays_with_hubs_are_equal(void** state)
{
	(void)state;
	FormCounts sum = check_forms(hub_forms, sizeof hub_forms / sizeof *hub_forms, true);
	assert_true(sum.registers > 0 && sum.streamed > 0 && sum.split > 0);
	assert_true(sum.by_hubs > sum.solves / 2);
	assert_int_equal(sum.spread, 8);
}

// ---------------------------------------------------------------------------------------------------------------
// work-items that never get a turn
// ---------------------------------------------------------------------------------------------------------------

// One group begins only after all others have ended, as on a device that has no room for all groups.
static void shunned_groups_are_found(void** state)
{
	(void)state;
	for (int group = 1; group <= 3; ++group)
	{
		check_fault("pyramid", (Form){.name = "registers", .groups = 16, .schedule.shunned = group});
		check_fault("pyramid", (Form){.name = "streamed", .groups = 3, .schedule.shunned = group});
		check_fault("hubs",
		            (Form){.name = "hubs", .groups = 4, .group = 32, .hub_groups = 2, .schedule.shunned = group});
	}
}

// Checks that each word written to a mailbox is needed: if one is lost, the solve fails.
static void lost_words_are_found(void** state)
{
	(void)state;
	check_lost("pyramid", (Form){.name = "registers", .groups = 16});
	check_lost("heap", (Form){.name = "streamed", .groups = 2, .schedule.late = true});
	check_lost("hub", (Form){.name = "hub", .groups = 3, .group = 32, .hub_groups = 1});
	check_lost("raft", (Form){.name = "raft", .groups = 1, .group = 64});
	check_lost("joints", (Form){.name = "joints", .groups = 2, .schedule.late = true});
	check_lost("hubs", (Form){.name = "hubs", .groups = 4, .group = 32, .hub_groups = 2, .schedule.late = true});
}

// ---------------------------------------------------------------------------------------------------------------
// words of another step
// ---------------------------------------------------------------------------------------------------------------

// The third pass of a step is the first that reads displacements. If two words of a mailbox already carry the ticket of
// that pass, they are read as a displacement, so mailboxes must be cleared between steps. A single word with this
// ticket is not read.
static void mailboxes_must_be_cleared(void** state)
{
	(void)state;
	const int body = 30, pass = 2, displacement = 2;
	const FormScene* scene = form_scene("pyramid");
	const Form form = {.name = "registers", .groups = 16, .schedule.seed = 5};
	for (int words = 0; words <= 3; ++words)
	{
		scree_world *plain = open_world(-10.0f), *emulated = open_world(-10.0f);
		scene->build(plain);
		scene->build(emulated);
		form_take(emulated, &form);
		run_steps(plain, 10);
		run_steps(emulated, 10);
		for (int k = 0; k < 2; ++k)
			if (words >> k & 1)
				form_spoil(body, displacement + k, (uint64_t)(relay_tickets * pass + 1) << 16);
		run_steps(plain, 1);
		run_steps(emulated, 1);
		assert_int_equal(hash_of(plain) == hash_of(emulated), words < 3);
		scree_world_destroy(plain);
		scree_world_destroy(emulated);
		form_close();
	}
}

// ---------------------------------------------------------------------------------------------------------------
// the probe, and the emulation itself
// ---------------------------------------------------------------------------------------------------------------

static void probe_reports(void** state)
{
	(void)state;
	for (uint64_t seed = 1; seed <= 5; ++seed)
	{
		assert_int_equal(probe_run(4, 32, 16, 1 << 16, &(Schedule){.seed = seed}), 0);
		assert_int_equal(probe_run(3, 32, 16, 1 << 16, &(Schedule){.seed = seed, .late = true, .pieces = 8}), 0);
		assert_int_equal(probe_run(4, 32, 16, 1 << 16, &(Schedule){.seed = seed, .late = true, .pieces = 4}),
		                 fault_stale);
		for (int group = 1; group <= 4; ++group)
			assert_int_equal(probe_run(4, 32, 16, 1000, &(Schedule){.seed = seed, .shunned = group}), fault_timeout);
	}
	items_close();
}

static void half_meet(const void* met)
{
	if (items_lane() % 2)
		return;
	items_meet(__FILE__, __LINE__);
	++*(int*)(uintptr_t)met;
}

static void apart_meet(const void* met)
{
	(void)met;
	if (items_lane() % 2)
		items_meet(__FILE__, __LINE__);
	else
		items_meet(__FILE__, __LINE__);
}

// Checks that a barrier which some work-items miss is reported.
static void barriers_are_strict(void** state)
{
	(void)state;
	int met = 0;
	char sentence[ITEMS_SENTENCE];
	Launch launch = {3, 8, half_meet, &met};
	assert_false(items_run(&launch, &(Schedule){.seed = 3}, sentence));
	assert_non_null(strstr(sentence, "12 of 24 work-items ended"));
	assert_int_equal(met, 0);
	assert_true(items_run(&launch, &(Schedule){.seed = 3, .leavers = true}, sentence));
	assert_int_equal(met, 12);
	launch.item = apart_meet;
	assert_false(items_run(&launch, &(Schedule){.seed = 3}, sentence));
	assert_non_null(strstr(sentence, "different barriers"));
	items_close();
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(barriers_are_strict),       cmocka_unit_test(probe_reports),
	    cmocka_unit_test(relays_are_equal),          cmocka_unit_test(relays_with_hubs_are_equal),
	    cmocka_unit_test(shunned_groups_are_found),  cmocka_unit_test(lost_words_are_found),
	    cmocka_unit_test(mailboxes_must_be_cleared),
	};
	int refused = check_refused();
	return refused ? refused : cmocka_run_group_tests(tests, NULL, NULL);
}
