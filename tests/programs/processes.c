// SPDX-License-Identifier: MIT
// processes.c -- runs programs in several processes; one_process.c replaces it on systems without fork.
//
// A process writes the seed of its program to memory that its parent can read. So the parent can report a program that
// crashed or hangs.
#include "programs/farm.h"
#include "tools/common/clock.h"
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

// Returns whether a process has ended. Kills a process that hangs, and prints the failure.
static bool ended(const Options* o, Desk* desk, pid_t child)
{
	int status = 0;
	bool late = !desk->finished && seconds_now() - desk->since > o->limit;
	if (late)
		kill(child, SIGKILL);
	if (waitpid(child, &status, late ? 0 : WNOHANG) != child)
		return false;
	if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
		return true;
	desk->failed += 1;
	char form[40];
	printf("program %" PRIu64 ": %s (status %d); again: programs --seed %" PRIu64
	       " --programs 1 --calls %d --device %s --form %s\n",
	       desk->seed, late ? "it hangs" : "the process crashed", status, desk->seed, o->calls, o->places[1].device,
	       farm_form(o, form));
	return true;
}

int farm_run(const Options* o)
{
	Desk* desks = mmap(NULL, MOST_JOBS * sizeof *desks, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	pid_t children[MOST_JOBS] = {0};
	if (desks == MAP_FAILED)
	{
		fprintf(stderr, "programs: no memory for %d processes\n", o->jobs);
		return 2;
	}
	double begin = seconds_now();
	// a report is printed by one call of the system, so that those of two processes do not mix
	static char buffer[1 << 20];
	setvbuf(stdout, buffer, _IOFBF, sizeof buffer);
	for (int k = 0; k < o->jobs; ++k)
	{
		desks[k].since = begin;
		children[k] = fork();
		if (children[k] == 0)
		{
			farm_work(o, k, &desks[k]);
			exit(0);
		}
	}
	Desk all = {0};
	for (int left = o->jobs; left > 0; usleep(20000))
		for (int k = 0; k < o->jobs; ++k)
		{
			if (children[k] == 0 || !ended(o, &desks[k], children[k]))
				continue;
			children[k] = 0;
			--left;
			all.done += desks[k].done;
			all.failed += desks[k].failed;
			all.steps += desks[k].steps;
			all.frozen += desks[k].frozen;
			all.batches += desks[k].batches;
			all.sleeping += desks[k].sleeping;
			all.woken += desks[k].woken;
			all.hash += desks[k].hash;
		}
	return farm_print_counts(o, &all, seconds_now() - begin);
}
