// SPDX-License-Identifier: MIT
// sample_worlds.h -- declares the small worlds by which devices are tested.
#ifndef SAMPLE_WORLDS_H
#define SAMPLE_WORLDS_H
#include "scree/scree.h"

typedef struct
{
	const char* name; // for messages
	scree_status (*fill)(scree_world* world);
} SampleWorld;

#define SAMPLE_WORLDS 5
extern const SampleWorld sample_worlds[SAMPLE_WORLDS];

#endif
