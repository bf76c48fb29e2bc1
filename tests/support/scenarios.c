// SPDX-License-Identifier: MIT
// scenarios.c -- records repeatable simulations step by step, and compares their hashes.
#include "support/scenarios.h"
#include "support/different_pools.h"
#include <stdlib.h>
#include <string.h>

Scenario scenario_of(const char* name, int steps, void (*build)(scree_world* world, const void* context),
                     void (*act)(scree_world* world, int step, const void* context), const void* context)
{
	return (Scenario){.name = name,
	                  .def = scree_world_def_default(),
	                  .dt = STEP,
	                  .substeps = SUBSTEPS,
	                  .steps = steps,
	                  .build = build,
	                  .act = act,
	                  .context = context};
}

static scree_world* open_scenario(const Scenario* scenario, const Variant* variant)
{
	scree_world* world = open_variant(variant, &scenario->def);
	scenario->build(world, scenario->context);
	return world;
}

static void scenario_step(const Scenario* scenario, scree_world* world, int step, const Variant* variant)
{
	if (scenario->act)
		scenario->act(world, step, scenario->context);
	// moves the world while changes of the scenario are still pending
	if (variant->other[0] && step % 40 == 9)
		OK(scree_world_move(world, variant->other));
	if (variant->other[0] && step % 40 == 25)
		OK(scree_world_move(world, variant->device));
	OK(scree_world_step(world, scenario->dt, scenario->substeps));
}

void record(const Scenario* scenario, const Variant* variant, uint64_t* hashes, scree_counters* last)
{
	scree_world* world = open_scenario(scenario, variant);
	for (int k = 0; k < scenario->steps; ++k)
	{
		scenario_step(scenario, world, k, variant);
		hashes[k] = hash_of(world);
	}
	if (last)
		*last = counters_of(world);
	check_finite(world);
	scree_world_destroy(world);
}

// Runs two scenarios side by side up to the first step in which their hashes differ. Then fails the test.
static void fail_different(const Scenario* scenario_a, const Variant* variant_a, const Scenario* scenario_b,
                           const Variant* variant_b)
{
	scree_world* a = open_scenario(scenario_a, variant_a);
	scree_world* b = open_scenario(scenario_b, variant_b);
	for (int k = 0; k < scenario_a->steps; ++k)
	{
		scenario_step(scenario_a, a, k, variant_a);
		scenario_step(scenario_b, b, k, variant_b);
		if (hash_of(a) == hash_of(b))
			continue;
		print_message("%s, step %d: %s | %s\n", scenario_a->name, k, variant_a->name, variant_b->name);
		print_different_pools(a, b);
		fail_msg("%s: %s and %s differ from step %d on", scenario_a->name, variant_a->name, variant_b->name, k);
	}
	fail_msg("%s: %s and %s differed, and do not when run again", scenario_a->name, variant_a->name, variant_b->name);
}

uint64_t check_parity(const Scenario* scenario, scree_counters* last)
{
	static Variant variants[MAX_VARIANTS];
	static int count, round;
	count = count > 0 ? count : list_variants(variants);
	size_t bytes = (size_t)scenario->steps * sizeof(uint64_t);
	uint64_t* expected = malloc(bytes);
	uint64_t* hashes = malloc(bytes);
	for (int k = 0; k < count; ++k)
	{
		if (!variant_is_due(variants, count, k, round))
			continue;
		record(scenario, variants + k, k == 0 ? expected : hashes, k == 0 ? last : NULL);
		if (k > 0 && memcmp(hashes, expected, bytes) != 0)
			fail_different(scenario, variants, scenario, variants + k);
	}
	++round;
	uint64_t hash = expected[scenario->steps - 1];
	free(expected);
	free(hashes);
	return hash;
}

void check_equal(uint64_t (*run)(const Variant* variant))
{
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	uint64_t expected = run(variants);
	for (int k = 1; k < count; ++k)
		if (run(variants + k) != expected)
			fail_msg("%s has another hash than %s", variants[k].name, variants[0].name);
}

void check_same(const Scenario* a, const Scenario* b, const Variant* variant)
{
	size_t bytes = (size_t)a->steps * sizeof(uint64_t);
	uint64_t* expected = malloc(bytes);
	uint64_t* hashes = malloc(bytes);
	record(a, variant, expected, NULL);
	record(b, variant, hashes, NULL);
	if (memcmp(hashes, expected, bytes) != 0)
		fail_different(a, variant, b, variant);
	free(expected);
	free(hashes);
}
