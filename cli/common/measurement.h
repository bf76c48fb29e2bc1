// SPDX-License-Identifier: MIT
// measurement.h -- the steps of several runs of a scene: their check, and their row in the CSV of bench.
#ifndef MEASUREMENT_H
#define MEASUREMENT_H
#include "known_hashes.h"
#include "step_record.h"

typedef struct
{
	const Scene* scene;
	int steps;       // steps of each run
	Record* records; // the timed steps of all runs
	int count;
	int runs, begin;                 // finished runs; the first record of the next one
	int staged;                      // records of the last run, which have milliseconds by stage
	double least, most;              // median step of the fastest and of the slowest repeat, ms
	float penetration;               // deepest of all steps, m
	uint64_t hash, other;            // the first run's, and that of a later run if it differs
	uint64_t answers, other_answers; // the same for the rays of the scene
	int nonfinite;                   // steps that froze a body
	double bandwidth;                // bytes a second that the device copies; 0 until it has been measured
	char device[160];
	int threads, lanes;
} Measurement;

// Adds a step of a run; the first step is number 0.
void measurement_add(Measurement* m, const Record* record, int step);

// Ends a run. world: names the device; timings: the steps have milliseconds by stage; answers: the hash of the rays.
void measurement_end_run(Measurement* m, const scree_world* world, bool timings, uint64_t hash, uint64_t answers);

// Whether the work was done; if not, prints why.
bool measurement_check(const Measurement* m, const Known* known, const Options* options, const char* settings);

// Print the CSV. stages: names of the columns of Record.stages.
void measurement_print_heading(const char* const* stages);
void measurement_print(Measurement* m, const char* settings, bool valid);

#endif
