// SPDX-License-Identifier: MIT
// farm.c -- runs many programs in several processes, and reports those that fail.
//
// A process writes the seed of its program to memory that its parent can read. So the parent can report a program that
// crashed or hangs.
#include "programs/farm.h"
#include "support/form_names.h"
#include "tools/common/clock.h"
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct // progress of a process, shared with its parent
{
	uint64_t seed;
	double since; // s, by seconds_now: start of the current program
	int done, failed, steps, frozen;
	uint64_t hash; // sum of those of the programs
	bool finished;
} Desk;

bool farm_print(Pair* pair, const Program* program, const char* what, FILE* file)
{
	pair_forget(pair);
	Outcome outcome = pair_run(pair, program, file);
	pair_forget(pair);
	if (outcome.differs)
		fprintf(file, "%s: after call %d, %s: %s\n", what, outcome.call,
		        call_info(program->calls[outcome.call].kind)->name, outcome.sentence);
	return outcome.differs;
}

static bool differs_anew(Pair* pair, const Program* program)
{
	pair_forget(pair);
	return pair_run(pair, program, NULL).differs;
}

bool farm_shrink(Pair* pair, Program* program, double seconds)
{
	if (!differs_anew(pair, program))
		return false;
	Program whole = {0};
	program_copy(&whole, program);
	program_shrink(program, pair, seconds);

	// trials run on reused worlds to save time, so an earlier trial may have caused the difference
	if (seconds > 0.0 && !differs_anew(pair, program))
	{
		program_copy(program, &whole);
		pair->anew = true;
		program_shrink(program, pair, seconds);
		pair->anew = false;
	}
	program_close(&whole);
	return true;
}

// Shortens a program after which the worlds differ, prints it and writes it to a file. If new worlds do not differ
// after the program, the earlier programs on the same worlds are put before it.
// Writes the name of the form and the arithmetic of the second world.
static const char* form_of(const Options* o, char text[40])
{
	return form_name(solve_form_setting,
	                 (Arithmetic){.rounding = arithmetic_setting.rounding, .flush = o->places[1].flush}, text);
}

static void report(const Options* o, Pair* pair, Program* program, Program* before, uint64_t seed)
{
	char path[512], what[64];
	snprintf(what, sizeof what, "program %" PRIu64, seed);
	snprintf(path, sizeof path, "%s/program-%" PRIu64 ".txt", o->out, seed);
	if (!farm_shrink(pair, program, o->shrink) && before->count > 0)
	{
		program_add_empty(before);
		for (int k = 1; k < program->count; ++k)
			program_add(before, program->calls[k]);
		program_copy(program, before);
		farm_shrink(pair, program, o->shrink);
	}
	char* text = NULL;
	size_t length = 0;
	char form[40];
	FILE* memory = open_memstream(&text, &length);
	if (!memory)
		return;
	if (!farm_print(pair, program, what, memory))
		fprintf(memory, "%s: differed, and does not when run again\n", what);
	program_write(program, memory);
	fprintf(memory, "again: programs --device %s --form %s --replay %s\n\n", o->places[1].device, form_of(o, form),
	        path);
	fclose(memory);
	fwrite(text, 1, length, stdout);
	fflush(stdout);
	free(text);
	FILE* file = fopen(path, "w");
	if (!file)
		return;
	program_write(program, file);
	fclose(file);
}

// Runs programs `first` to `end` - 1 on the same worlds. The seed of program k is Options.seed + k. until: s, time
// after which no program is started.
static void live(const Options* o, Pair* pair, int first, int end, double until, Desk* desk, int* reports)
{
	Program program = {0}, before = {0};
	pair_forget(pair);
	for (int k = first; k < end && seconds_now() < until; ++k)
	{
		uint64_t seed = o->seed + (uint64_t)k;
		desk->since = seconds_now();
		desk->seed = seed;
		program_make(&program, seed, o->calls);
		pair->every = o->every;
		pair->first_read = (uint32_t)(seed % READ_CHOICES);
		Outcome outcome = pair_run(pair, &program, NULL);
		pair->every = 1;
		desk->steps += outcome.steps;
		desk->frozen += outcome.frozen;
		desk->done += 1;
		desk->hash += outcome.hash;
		if (outcome.differs)
		{
			desk->failed += 1;
			desk->since = seconds_now() + 4.0 * o->shrink;
			if ((*reports)++ < o->reports)
				report(o, pair, &program, &before, seed);
			pair_forget(pair);
			before.count = 0;
			continue;
		}
		if (before.count == 0)
			program_add(&before, program.calls[0]);
		else
			program_add_empty(&before);
		for (int i = 1; i < program.count; ++i)
			program_add(&before, program.calls[i]);
	}
	program_close(&program);
	program_close(&before);
}

static void work(const Options* o, int job, Desk* desk)
{
	Pair pair;
	pair_open(&pair, o->places);
	pair.infinite = o->infinite;
	pair.limits = o->limits;
	double until = o->seconds > 0.0 ? seconds_now() + o->seconds : INFINITY;
	int reports = 0, stride = o->jobs * o->life;
	for (int first = job * o->life; first < o->programs && seconds_now() < until; first += stride)
	{
		int end = first + o->life < o->programs ? first + o->life : o->programs;
		live(o, &pair, first, end, until, desk, &reports);
	}
	pair_close(&pair);
	desk->finished = true;
}

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
	       form_of(o, form));
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
	fflush(stdout);
	for (int k = 0; k < o->jobs; ++k)
	{
		desks[k].since = begin;
		children[k] = fork();
		if (children[k] == 0)
		{
			work(o, k, &desks[k]);
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
			all.hash += desks[k].hash;
		}
	printf("%s: %d programs, %d steps, %d bodies frozen, %d failures, hash %016" PRIx64 ", %.1f s\n",
	       o->places[1].device, all.done, all.steps, all.frozen, all.failed, all.hash, seconds_now() - begin);
	return all.failed > 0;
}
