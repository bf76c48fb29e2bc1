// SPDX-License-Identifier: MIT
// validate.h -- experiments that check physical behavior against limits; prints rows of results.
#ifndef VALIDATE_H
#define VALIDATE_H
#include "experiment_support.h"
#include "lab_overlap.h"

typedef struct // run makes it with the engine of the validation
{
	const char *name, *shows;
	void (*run)(Validation* v);
} Experiment;

extern const Experiment validate_experiments[];
extern const int validate_count;

// Returns null when no experiment has the name.
const Experiment* validate_find(const char* name);

typedef struct // the largest value of some runs, and the run that gave it
{
	double value;
	char at[64];
} Peak;

// Takes a value that is larger, or no number, as an engine that failed gives it; that stays.
void peak_take(Peak* peak, double value, const char* at);

void validate_heading(FILE* out);

// Runs one experiment and prints its rows. False when an engine failed or a row is beyond its limit.
bool validate_run(Validation* v, const Experiment* experiment);

// For experiments: begin starts a case, where names the run that gave the value of the next row, row prints a row.
void begin(Validation* v, const char* format, ...) __attribute__((format(printf, 2, 3)));
void where(Validation* v, const char* format, ...) __attribute__((format(printf, 2, 3)));
void row(Validation* v, const char* quantity, double value, const char* unit, Limit limit, double bound);

#endif
