// SPDX-License-Identifier: MIT
// processes.c -- runs seeds in several processes; one_process.c replaces it on systems without fork.
//
// A process writes its current seed to memory that its parent can read. So the parent can report a seed that crashed or
// hangs.
#include "programs/jobs.h"
#include "tools/common/clock.h"
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

// Returns whether a process has ended. Kills a process that hangs, and prints the failure.
static bool ended(const Jobs* jobs, Progress* progress, pid_t child)
{
	int status = 0;
	bool late = !progress->finished && seconds_now() - progress->since > jobs->limit;
	if (late)
		kill(child, SIGKILL);
	if (waitpid(child, &status, late ? 0 : WNOHANG) != child)
		return false;
	if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
		return true;
	progress->failed += 1;
	jobs->report(jobs->options, progress->seed, late, status);
	return true;
}

bool jobs_run(const Jobs* jobs, void* all)
{
	size_t bytes = MOST_JOBS * jobs->size;
	char* sums = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	pid_t children[MOST_JOBS] = {0};
	if (sums == MAP_FAILED)
		return false;
	// a report is printed by one call of the system, so that those of two processes do not mix
	static char buffer[1 << 20];
	setvbuf(stdout, buffer, _IOFBF, sizeof buffer);
	for (int k = 0; k < jobs->jobs; ++k)
	{
		char* own = sums + (size_t)k * jobs->size;
		((Progress*)own)->since = seconds_now();
		children[k] = fork();
		if (children[k] == 0)
		{
			jobs->work(jobs->options, k, jobs->jobs, own);
			exit(0);
		}
	}
	for (int left = jobs->jobs; left > 0; usleep(20000))
		for (int k = 0; k < jobs->jobs; ++k)
		{
			char* own = sums + (size_t)k * jobs->size;
			if (children[k] == 0 || !ended(jobs, (Progress*)own, children[k]))
				continue;
			children[k] = 0;
			--left;
			jobs->add(all, own);
		}
	munmap(sums, bytes);
	return true;
}
