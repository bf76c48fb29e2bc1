// SPDX-License-Identifier: MIT
// scenarios.h -- records repeatable simulations step by step, and compares their hashes.
#ifndef SCENARIOS_H
#define SCENARIOS_H
#include "support/make_worlds.h"
#include "support/variants.h"

typedef struct
{
	const char* name;
	scree_world_def def; // settings of the world; device, threads and lanes come from the variant
	float dt;
	int substeps, steps;
	void (*build)(scree_world* world, const void* context);
	void (*act)(scree_world* world, int step, const void* context); // is called before each step, and may be null
	const void* context;
} Scenario;

// Returns a scenario with default settings of the world. Each step has the length STEP and SUBSTEPS substeps.
Scenario scenario_of(const char* name, int steps, void (*build)(scree_world* world, const void* context),
                     void (*act)(scree_world* world, int step, const void* context), const void* context);

// Runs a scenario. Writes the hash after each step to hashes, and the final counters to `last`, which may be null.
// Fails if a state is not finite at the end.
void record(const Scenario* scenario, const Variant* variant, uint64_t* hashes, scree_counters* last);

// Records a scenario on every variant. Fails unless all variants have equal hashes after every step. The message
// contains the first step and the pools that differ. Returns the final hash. last: receives the final counters of
// variant 0, the reference; may be null.
uint64_t check_parity(const Scenario* scenario, scree_counters* last);

// Fails unless a function returns the same hash on every variant.
void check_equal(uint64_t (*run)(const Variant* variant));

// Fails unless two scenarios have the same hashes on a variant. The settings of the scenarios differ, but must not
// influence results.
void check_same(const Scenario* a, const Scenario* b, const Variant* variant);

#endif
