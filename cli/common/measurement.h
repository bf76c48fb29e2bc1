// SPDX-License-Identifier: MIT
// measurement.h -- collects the steps of several runs of a scene, checks them, and prints their row in the CSV of
// bench.
#ifndef MEASUREMENT_H
#define MEASUREMENT_H
#include "known_hashes.h"
#include "step_record.h"

typedef struct
{
	const Scene* scene;
	int steps;       // number of steps of each run
	Record* records; // measured steps of all runs
	int count;
	int runs, begin;                 // number of finished runs; index of the first record of the next run
	int staged;                      // number of records with stage times; they are the last records
	double least, most;              // ms: median step of the fastest and of the slowest run without stage times
	float penetration;               // m: deepest overlap of all steps
	uint64_t hash, other;            // hash of the first run; last hash that differs from it, or the same hash
	uint64_t answers, other_answers; // the same two hashes for the results of the scene's rays
	int nonfinite;                   // number of steps that froze a body
	double bandwidth;                // copy bandwidth of the device, bytes/s; 0 until it has been measured
	char device[160];
	int threads, lanes;
} Measurement;

// Adds a step of a run; the first step is number 0. The first steps of a run are checked, but not recorded.
void measurement_add(Measurement* m, const Record* record, int step);

// Ends a run. world: supplies the name of the device; timings: true if the steps have milliseconds by stage; hash:
// hash of the final state; answers: hash of the results of the rays.
void measurement_end_run(Measurement* m, const scree_world* world, bool timings, uint64_t hash, uint64_t answers);

// Returns true if the results are valid; if not, prints all reasons.
bool measurement_check(const Measurement* m, const Known* known, const Options* options, const char* settings);

// Print the heading and a row of the CSV. stages: names of the columns of Record.stages.
void measurement_print_heading(const char* const* stages);
void measurement_print(Measurement* m, const char* settings, bool valid);

#endif
