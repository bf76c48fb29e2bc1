// SPDX-License-Identifier: MIT
// validate.h -- lists and runs experiments, which check physical behavior against limits and print rows of results.
#ifndef VALIDATE_H
#define VALIDATE_H
#include "experiment_support.h"
#include "lab_overlap.h"

typedef struct // `run` executes the experiment with the engine of the validation
{
	const char *name, *shows;
	void (*run)(Validation* v);
} Experiment;

extern const Experiment validate_experiments[];
extern const int validate_count;

// Returns the experiment with this name; null if there is none.
const Experiment* validate_find(const char* name);

typedef struct // largest value of several runs, and the name of the run with this value
{
	double value;
	char at[64];
} Peak;

// Replaces the stored value by `value` if this is larger or NaN; an experiment gives NaN after its engine failed. A
// stored NaN is never replaced. at: name of the run.
void peak_take(Peak* peak, double value, const char* at);

void validate_heading(FILE* out);

// Runs one experiment and prints its rows. Returns false if an engine failed or if a value is beyond its limit.
bool validate_run(Validation* v, const Experiment* experiment);

// Functions for experiments. `begin` starts a case. `where` sets the last column of the next row: the name of the run
// that gave the value. `row` prints a row, and counts a failure if the value is beyond `bound`.
void begin(Validation* v, const char* format, ...) __attribute__((format(printf, 2, 3)));
void where(Validation* v, const char* format, ...) __attribute__((format(printf, 2, 3)));
void row(Validation* v, const char* quantity, double value, const char* unit, Limit limit, double bound);

#endif
