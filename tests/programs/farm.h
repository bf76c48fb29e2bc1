// SPDX-License-Identifier: MIT
// farm.h -- many programs by many processes, and what becomes of those that fail.
#ifndef FARM_H
#define FARM_H
#include "programs/program.h"

typedef struct
{
	int programs, calls, jobs, life, reports, every;
	bool shown, infinite, limits;
	uint64_t seed;
	double shrink, limit, seconds; // s
	const char *out, *replay;
	Place places[2];
} Options;

#define MOST_JOBS 64

// Runs them and prints what fails, and a line with counts; 1 when something failed.
int farm_run(const Options* options);

// Runs a program on worlds that are new, and prints how it differs.
bool farm_print(Pair* pair, const Program* program, const char* what, FILE* file);

// A program that differs on new worlds, made shorter, which still does; false when it does not differ.
bool farm_shrink(Pair* pair, Program* program, double seconds);

#endif
