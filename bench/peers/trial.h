// SPDX-License-Identifier: MIT
// trial.h -- one engine, one scene, one process: timed or measured.
#ifndef TRIAL_H
#define TRIAL_H
#include "setup.h"
#include "validate/engine.h"

#define FIRST_STEPS 150

typedef struct
{
	const Setup* setup;
	int steps;
	bool measured; // every step is measured and not timed
	EngineOptions options;
} Trial;

typedef struct
{
	double mean, median; // ms a step, the first steps left out; zeros when measured
	double first;        // the same mean, up to step FIRST_STEPS: while bodies still fall
	float penetration;   // deepest of all steps, m; zero unless measured, as the next five
	float depth;         // mean of the deepest of each step, m
	float contacts;      // touching ones, mean of all steps
	float sunk;          // largest distance that a body sank, m
	float separation;    // largest separation of the anchors of a joint over all steps, m
	float gap;           // mean of it over all joints and steps, m
	uint64_t hash;       // the engine's own, at the end
} Result;

// Runs a trial in this process. False after printing a sentence.
bool trial_run(const Engine* engine, const Trial* trial, Result* result);

// A process writes its result as one line of text, which another reads.
void result_print(const Result* result);
bool result_scan(const char* line, Result* result);

#endif
