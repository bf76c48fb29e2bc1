// SPDX-License-Identifier: MIT
// sleep_trial.h -- runs a world of a case once, and measures its steps.
#ifndef SLEEP_TRIAL_H
#define SLEEP_TRIAL_H
#include "sleep_run.h"

#define FIRST_STEPS 8     // steps after a call that wakes bodies; their longest one is the step that wakes
#define MAX_STEPS   10000 // steps of a run that are timed

typedef struct
{
	double mean, median, most; // ms a step; if bodies wake: median of the later steps, longest of the first ones
	double first[FIRST_STEPS]; // ms of each of the first steps
	scree_counters counters;   // at the end
	uint64_t hash;
	float penetration;   // deepest overlap of all steps, m; 0 if the run was not checked
	int frozen;          // frozen bodies of all steps; 0 if the run was not checked
	int asleep;          // expected number of sleeping bodies at the end
	int found, expected; // hits or visits, and their correct number
	int steps;           // steps that were timed
	char device[128];
	int threads, lanes;
} SleepResult;

// Runs one world of a case. compared: the world with which that of the case is compared. checked: reads counters after
// each step; then the times are those of the steps with these reads. Returns false after printing a message.
bool sleep_trial_run(const SleepCase* item, const SleepSetting* setting, bool compared, bool checked,
                     SleepResult* result);

#endif
