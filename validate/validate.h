// SPDX-License-Identifier: MIT
// validate.h -- experiments that say whether what must hold does, one row a case.
#ifndef VALIDATE_H
#define VALIDATE_H
#include "lab.h"
#include <stdio.h>

typedef struct // a function runs it with the engine of the validation
{
	const char *name, *shows;
	void (*run)(Validation* v);
} Experiment;

extern const Experiment validate_experiments[];
extern const int validate_count;

typedef enum
{
	SHOWN,   // has no limit
	AT_MOST, // the value may not be more, nor anything but a number
	AT_LEAST,
} Limit;

struct Validation
{
	const LabEngine* engine;
	LabOptions options;
	const char* executable; // beside which scenes may lie; may be null
	bool quick;             // fewer and shorter runs, for tests
	FILE* out;

	Lab* lab;               // that is open, or null
	const char* experiment; // that runs
	char text[96];          // of the case
	char where[128];        // which run gave the value, or nothing
	int64_t steps;          // since the case began
	uint64_t hash;          // of the end states of labs closed since then
	int failures;           // rows beyond their limits
	bool broken;            // an engine or memory failed
};

// Null when no experiment has the name.
const Experiment* validate_find(const char* name);

void validate_heading(FILE* out);

// Runs one experiment and prints its rows. False when an engine failed or a row is beyond its limit.
bool validate_run(Validation* v, const Experiment* experiment);

// For experiments: begins a case; says which run gave the value of the next row; prints a row.
void begin(Validation* v, const char* format, ...) __attribute__((format(printf, 2, 3)));
void where(Validation* v, const char* format, ...) __attribute__((format(printf, 2, 3)));
void row(Validation* v, const char* quantity, double value, const char* unit, Limit limit, double bound);

// The hash of all end states of the case, the state of the open lab among them.
uint64_t validate_hash(Validation* v);

// Memory that was asked for; without it the program ends with a sentence.
void* demand(void* memory);

// The middle one of values, which it puts in order.
double middle(double* values, int count);

// The same numbers on every machine, by Sebastiano Vigna, splitmix64, 2015.
double random_between(uint64_t* seed, double low, double high);

#endif
