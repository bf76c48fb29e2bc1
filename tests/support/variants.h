// SPDX-License-Identifier: MIT
// variants.h -- the devices, numbers of threads and lanes, and forms of the solve on which a world must have the same
// bits.
#ifndef VARIANTS_H
#define VARIANTS_H
#include "backend/solve_form.h"
#include "support/checks.h"

typedef struct // a device and the settings of a world on it
{
	char name[160];
	char device[128];
	int threads, lanes;
	SolveForm form;
	char other[128]; // device to which the world sometimes moves, and back; empty for none
} Variant;

#define MAX_VARIANTS 32

// Lists the variants. The first is the reference: one thread, one lane. Then come every number of lanes of the
// processor, with one thread and with two, and every OpenCL device with equal bits, in each form of its solve. Then
// comes a world that moves between the CPU and each of these devices.
int list_variants(Variant variants[MAX_VARIANTS]);
void print_variants(void);

// Returns whether variant k is part of a round. In quick builds, which look for faults of the host's code, the OpenCL
// variants take turns.
bool variant_is_due(const Variant* variants, int count, int k, int round);

// Creates a world with def, but with the device, threads and lanes of the variant.
scree_world* open_variant(const Variant* variant, const scree_world_def* def);

// Creates a world with the default definition.
scree_world* open_default_variant(const Variant* variant);

#endif
