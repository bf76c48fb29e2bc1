// SPDX-License-Identifier: MIT
// variants.h -- the devices, numbers of threads and lanes, and forms of the solver on which a world must have the same bits.
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
	char other[128]; // the device to which the world moves now and then, and back; empty for none
} Variant;

#define MAX_VARIANTS 32

// The first is the reference: one thread, one lane. Then every number of lanes that the processor has with one thread
// and with two, and every OpenCL device that keeps equal bits, with its solver in each of its forms. Then a world
// that moves between the CPU and each of these devices.
int list_variants(Variant variants[MAX_VARIANTS]);
void print_variants(void);

// Whether variant k is part of a round. In quick builds, which look for faults of the host's code, the OpenCL variants rotate.
bool variant_is_due(const Variant* variants, int count, int k, int round);

// Creates a world there; of def all but device, threads and lanes counts.
scree_world* open_variant(const Variant* variant, const scree_world_def* def);

// The same with the defaults.
scree_world* open_default_variant(const Variant* variant);

#endif
