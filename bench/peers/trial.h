// SPDX-License-Identifier: MIT
// trial.h -- runs a scene in an engine, and either measures the time of the steps or measures the poses after them.
#ifndef TRIAL_H
#define TRIAL_H
#include "setup.h"
#include "validate/engine.h"

#define FIRST_STEPS 150

typedef struct
{
	const Setup* setup;
	int steps;
	bool measured; // true: poses are measured after every step; false: steps are timed
	EngineOptions options;
} Trial;

typedef struct
{
	// results of a timed trial, ms per step, without the steps of the warm-up; 0 in a measured trial
	double mean, median;
	double first; // mean of the steps up to FIRST_STEPS, in which bodies fall
	// results of a measured trial; 0 in a timed trial
	float penetration; // deepest overlap of all steps, m
	float depth;       // mean over all steps of the deepest overlap, m
	float contacts;    // mean number of touching contacts over all steps
	float sunk;        // largest descent of a body from the start to the last step, m
	float separation;  // largest distance of the anchor of a joint from its locked place over all steps, m
	float gap;         // mean distance of an anchor from its locked place over all joints and steps, m
	int awake;         // number of dynamic bodies that are awake at the end
	int rested;        // number of the step since which all dynamic bodies sleep; 0: not all sleep at the end
	// result of both kinds of trials
	uint64_t hash; // hash of the final state, computed by the engine
} Result;

// Runs a trial in this process and fills result. Returns false after printing a sentence.
bool trial_run(const Engine* engine, const Trial* trial, Result* result);

// Print a result as one line of text (result_print), and read such a line (result_scan, which returns false if the line
// is not complete).
void result_print(const Result* result);
bool result_scan(const char* line, Result* result);

#endif
