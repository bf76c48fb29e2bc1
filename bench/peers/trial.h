// SPDX-License-Identifier: MIT
// trial.h -- one engine, one scene, one process: timed, or measured with the ruler.
#ifndef TRIAL_H
#define TRIAL_H
#include "engine.h"

typedef struct
{
	const Scene* scene;
	int steps;
	bool ruled; // not timed: every step is measured with the ruler instead
	EngineOptions options;
} Trial;

typedef struct
{
	double mean, median; // ms a step, the first steps left out; zeros when ruled
	float penetration;   // deepest of all steps, m; this and what follows but the hash are zero unless ruled
	float depth;         // mean of the deepest of each step, m
	float contacts;      // that touch, mean of all steps
	float sunk;          // how far the body that sank most did, m
	uint64_t hash;       // the engine's own, at the end
} Result;

// Runs a trial in this process. Returns false after printing what is wrong.
bool trial_run(const Engine* engine, const Trial* trial, Result* result);

// Results travel between processes as one line of text.
void result_print(const Result* result);
bool result_scan(const char* line, Result* result);

#endif
