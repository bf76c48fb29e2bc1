// SPDX-License-Identifier: MIT
// scenarios.h -- runs that can be repeated, recorded step by step and compared.
#ifndef SCENARIOS_H
#define SCENARIOS_H
#include "support/make_worlds.h"
#include "support/variants.h"

typedef struct
{
	const char* name;
	scree_world_def def; // device, threads and lanes follow the variant
	float dt;
	int substeps, steps;
	void (*build)(scree_world* world, const void* context);
	void (*act)(scree_world* world, int step, const void* context); // before each step; may be null
	const void* context;
} Scenario;

// Returns a scenario in a world with the defaults, with steps of STEP in SUBSTEPS.
Scenario scenario_of(const char* name, int steps, void (*build)(scree_world* world, const void* context),
                     void (*act)(scree_world* world, int step, const void* context), const void* context);

// Runs a scenario and writes the hash after each step. last gets the final counters, unless it is null.
void record(const Scenario* scenario, const Variant* variant, uint64_t* hashes, scree_counters* last);

// Records a scenario on every variant and fails unless all hashes of all steps are equal. The message contains the
// first step that differs and the pools that differ. Returns the last hash; last gets the counters of the reference,
// unless it is null.
uint64_t check_parity(const Scenario* scenario, scree_counters* last);

// Fails unless a run returns the same hash on every variant.
void check_equal(uint64_t (*run)(const Variant* variant));

// Fails unless two scenarios, which differ only in settings without effect on results, have the same hashes on one
// variant.
void check_same(const Scenario* a, const Scenario* b, const Variant* variant);

#endif
