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
	Record* records; // the measured steps of all runs
	int count;
	int runs, begin;                 // number of finished runs; first record of the next run
	int staged;                      // number of records of the last run, which have milliseconds by stage
	double least, most;              // ms: median step of the fastest and of the slowest repeat
	float penetration;               // m: deepest overlap of all steps
	uint64_t hash, other;            // hash of the first run, and that of a later run if it differs
	uint64_t answers, other_answers; // the same for the rays of the scene
	int nonfinite;                   // number of steps that froze a body
	double bandwidth;                // copy bandwidth of the device, bytes/s; 0 until it has been measured
	char device[160];
	int threads, lanes;
} Measurement;

// Adds a step of a run; the first step is number 0.
void measurement_add(Measurement* m, const Record* record, int step);

// Ends a run. world: supplies the name of the device; timings: true if the steps have milliseconds by stage; answers:
// the hash of the rays.
void measurement_end_run(Measurement* m, const scree_world* world, bool timings, uint64_t hash, uint64_t answers);

// Returns true if the results are valid; if not, prints the reason.
bool measurement_check(const Measurement* m, const Known* known, const Options* options, const char* settings);

// Print the CSV. stages: names of the columns of Record.stages.
void measurement_print_heading(const char* const* stages);
void measurement_print(Measurement* m, const char* settings, bool valid);

#endif
