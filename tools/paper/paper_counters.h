// SPDX-License-Identifier: MIT
// paper_counters.h -- declares the counters and times of the last step of the paper's pipeline.
#ifndef PAPER_COUNTERS_H
#define PAPER_COUNTERS_H
#include <stdint.h>

typedef struct
{
	int bodies, collidables;
	int contacts;      // overlapping pairs that the last step found
	float penetration; // m: deepest overlap of two bodies in these pairs
	int64_t steps;
} PaperCounters;

typedef struct // ms of the last step and its parts
{
	double step;                   // whole step, wall clock
	double to_device, from_device; // copies of the pools; zero on the CPU
	double integrate, transform, detect, resolve;
} PaperTimings;

#endif
