// SPDX-License-Identifier: MIT
// jobs.h -- runs seeds in several processes where the system has fork, and reports those that crash or hang.
#ifndef JOBS_H
#define JOBS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MOST_JOBS 64

typedef struct // progress of a process, shared with its parent; the first member of the sums of a process
{
	uint64_t seed;
	double since; // s, by seconds_now: start of the current seed
	int failed;
	bool finished;
} Progress;

typedef struct
{
	const void* options; // argument of the functions
	int jobs;            // number of processes
	double limit;        // s, after which a seed hangs
	size_t size;         // bytes of the sums of a process
	// runs the seeds of process `job` of `jobs` processes
	void (*work)(const void* options, int job, int jobs, void* sums);
	void (*report)(const void* options, uint64_t seed, bool late, int status); // prints that a seed crashed or hangs
	void (*add)(void* all, const void* sums);                                  // adds the sums of a process
} Jobs;

// Runs all processes, and adds their sums to *all. Returns false if there is no memory.
bool jobs_run(const Jobs* jobs, void* all); // defined in processes.c or one_process.c

#endif
