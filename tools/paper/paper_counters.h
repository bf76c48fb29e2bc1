// SPDX-License-Identifier: MIT
// paper_counters.h -- counters and times of the last step of the paper's pipeline.
#ifndef PAPER_COUNTERS_H
#define PAPER_COUNTERS_H
#include <stdint.h>

typedef struct
{
	int bodies, collidables;
	int contacts;      // overlapping pairs found by the last step
	float penetration; // deepest overlap of two bodies among them, m
	int64_t steps;
} PaperCounters;

typedef struct // milliseconds of the last step
{
	double step;                   // wall clock
	double to_device, from_device; // copying the pools; zero on the CPU
	double integrate, transform, detect, resolve;
} PaperTimings;

#endif
