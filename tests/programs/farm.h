// SPDX-License-Identifier: MIT
// farm.h -- runs many programs in several processes, and reports those that fail.
#ifndef FARM_H
#define FARM_H
#include "programs/program.h"

typedef struct
{
	int programs, calls, jobs, life, reports, every;
	bool shown, infinite, limits;
	uint64_t seed;
	double shrink, limit, seconds; // s: maximum times for shortening a program, for one program, and for all programs
	const char *out, *replay;
	Place places[2];
} Options;

#define MOST_JOBS 64

// Runs the programs. Prints failures and a line with counts. Returns 1 if a program failed, otherwise 0.
int farm_run(const Options* options);

// Runs a program on new worlds and prints the difference, with `what` as its name. Returns whether the worlds differ.
bool farm_print(Pair* pair, const Program* program, const char* what, FILE* file);

// Shortens a program after which new worlds differ. New worlds also differ after the shorter program. seconds: limit of
// time. Returns false if new worlds do not differ after the given program.
bool farm_shrink(Pair* pair, Program* program, double seconds);

#endif
