// SPDX-License-Identifier: MIT
// variants.h -- lists the devices, numbers of threads and lanes, and forms of the solve on which a world must have the
// same bits.
#ifndef VARIANTS_H
#define VARIANTS_H
#include "backend/solve_form.h"
#include "support/checks.h"

typedef struct // a device, and settings of a world on this device
{
	char name[160];
	char device[128];
	int threads, lanes;
	SolveForm form;
	char other[128]; // second device: the world moves there and back every 40 steps; empty: the world does not move
} Variant;

#define MAX_VARIANTS 32

// Lists the variants and returns their number. Variant 0 is the reference: one thread, one lane. The next variants have
// each number of lanes that the processor supports, with one thread (not in quick builds) and with two. The last ones
// are for OpenCL devices whose results have the same bits as those of the CPU: for each device, one variant per form of
// the solve, and one with a world that moves between the CPU and the device.
int list_variants(Variant variants[MAX_VARIANTS]);
void print_variants(void);

// Returns whether variant k must run in a round of a test. In release builds this is always true. Quick builds search
// for faults in the code of the host, so each round uses all CPU variants, but only one OpenCL variant.
bool variant_is_due(const Variant* variants, int count, int k, int round);

// Creates a world with the given definition, but with the device, threads, lanes and form of the variant.
scree_world* open_variant(const Variant* variant, const scree_world_def* def);

// Creates a world with the default definition, and the device, threads, lanes and form of the variant.
scree_world* open_default_variant(const Variant* variant);

#endif
