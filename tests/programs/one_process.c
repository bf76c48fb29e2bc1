// SPDX-License-Identifier: MIT
// one_process.c -- runs seeds in the calling process, on systems without fork; processes.c runs several processes.
//
// A seed that crashes ends the run, and one that hangs is not stopped.
#include "programs/jobs.h"
#include <stdlib.h>

bool jobs_run(const Jobs* jobs, void* all)
{
	void* sums = calloc(1, jobs->size);
	if (!sums)
		return false;
	jobs->work(jobs->options, 0, 1, sums);
	jobs->add(all, sums);
	free(sums);
	return true;
}
