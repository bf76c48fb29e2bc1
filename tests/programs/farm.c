// SPDX-License-Identifier: MIT
// farm.c -- runs many programs one after another, and reports those that fail.
#include "programs/farm.h"
#include "support/form_names.h"
#include "tools/common/clock.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

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

const char* farm_form(const Options* o, char text[40])
{
	return form_name(solve_form_setting,
	                 (Arithmetic){.rounding = arithmetic_setting.rounding, .flush = o->places[1].flush}, text);
}

// Shortens a program after which the worlds differ, prints it and writes it to a file. If new worlds do not differ
// after the program, the earlier programs on the same worlds are put before it.
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
	char form[40];
	if (!farm_print(pair, program, what, stdout))
		printf("%s: differed, and does not when run again\n", what);
	program_write(program, stdout);
	printf("again: programs --device %s --form %s --replay %s\n\n", o->places[1].device, farm_form(o, form), path);
	fflush(stdout);
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
		desk->progress.since = seconds_now();
		desk->progress.seed = seed;
		program_make(&program, seed, o->calls);
		pair->every = o->every;
		pair->first_read = (uint32_t)(seed % READ_CHOICES);
		Outcome outcome = pair_run(pair, &program, NULL);
		pair->every = 1;
		desk->steps += outcome.steps;
		desk->frozen += outcome.frozen;
		desk->batches += outcome.batches;
		desk->sleeping += outcome.slept > 0;
		desk->woken += outcome.woke > 0;
		desk->done += 1;
		desk->hash += outcome.hash;
		if (outcome.differs)
		{
			desk->progress.failed += 1;
			desk->progress.since = seconds_now() + 4.0 * o->shrink;
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

static void work(const void* options, int job, int jobs, void* sums)
{
	const Options* o = options;
	Desk* desk = sums;
	Pair pair;
	pair_open(&pair, o->places);
	pair.infinite = o->infinite;
	pair.limits = o->limits;
	pair.records = o->records;
	pair.record_path = o->record;
	double until = o->seconds > 0.0 ? seconds_now() + o->seconds : INFINITY;
	int reports = 0, stride = jobs * o->life;
	for (int first = job * o->life; first < o->programs && seconds_now() < until; first += stride)
	{
		int end = first + o->life < o->programs ? first + o->life : o->programs;
		live(o, &pair, first, end, until, desk, &reports);
	}
	pair_close(&pair);
	desk->progress.finished = true;
}

static void report_end(const void* options, uint64_t seed, bool late, int status)
{
	const Options* o = options;
	char form[40];
	printf("program %" PRIu64 ": %s (status %d); again: programs --seed %" PRIu64
	       " --programs 1 --calls %d --device %s --form %s\n",
	       seed, late ? "it hangs" : "the process crashed", status, seed, o->calls, o->places[1].device,
	       farm_form(o, form));
}

static void add(void* sum, const void* sums)
{
	Desk* all = sum;
	const Desk* desk = sums;
	all->done += desk->done;
	all->progress.failed += desk->progress.failed;
	all->steps += desk->steps;
	all->frozen += desk->frozen;
	all->batches += desk->batches;
	all->sleeping += desk->sleeping;
	all->woken += desk->woken;
	all->hash += desk->hash;
}

int farm_run(const Options* o)
{
	const Jobs jobs = {o, o->jobs, o->limit, sizeof(Desk), work, report_end, add};
	Desk all = {0};
	double begin = seconds_now();
	if (!jobs_run(&jobs, &all))
	{
		fprintf(stderr, "programs: no memory for %d processes\n", o->jobs);
		return 2;
	}
	printf("%s: %d programs, %d steps, %d batches, %d bodies frozen, %d with sleep, %d with waking, %d failures, hash "
	       "%016" PRIx64 ", %.1f s\n",
	       o->places[1].device, all.done, all.steps, all.batches, all.frozen, all.sleeping, all.woken,
	       all.progress.failed, all.hash, seconds_now() - begin);
	return all.progress.failed > 0;
}
