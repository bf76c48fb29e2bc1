// SPDX-License-Identifier: MIT
// farm.h -- runs many programs, in several processes where the system has fork, and reports those that fail.
#ifndef FARM_H
#define FARM_H
#include "programs/jobs.h"
#include "programs/program.h"

typedef struct
{
	int programs, calls, jobs, life, reports, every;
	bool shown, infinite, limits, records;
	uint64_t seed;
	double shrink, limit, seconds; // s: maximum times for shortening a program, for one program, and for all programs
	const char *out, *replay, *record;
	Place places[2];
} Options;

typedef struct // sums of a process
{
	Progress progress;
	int done, steps, frozen, batches;
	int sleeping, woken; // programs in which bodies fell asleep; programs in which bodies also woke
	uint64_t hash;       // sum of those of the programs
} Desk;

// Runs the programs. Prints failures and a line with counts. Returns 1 if a program failed, otherwise 0.
int farm_run(const Options* options);

// Writes the name of the form and the arithmetic of the second world.
const char* farm_form(const Options* options, char text[40]);

// Runs a program on new worlds and prints the difference, with `what` as its name. Returns whether the worlds differ.
bool farm_print(Pair* pair, const Program* program, const char* what, FILE* file);

// Shortens a program after which new worlds differ. New worlds also differ after the shorter program. seconds: limit of
// time. Returns false if new worlds do not differ after the given program.
bool farm_shrink(Pair* pair, Program* program, double seconds);

#endif
