// SPDX-License-Identifier: MIT
// main.c -- the command "mirror": runs hostile worlds in batches on a device, and each of them alone on the CPU.
#include "mirror/mirrored.h"
#include "programs/jobs.h"
#include "programs/program.h"
#include "tools/common/clock.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: mirror [OPTION...]\n"
    "Batches of worlds at the limits of what calls accept get random calls, which are repeated on each world alone, "
    "on\n"
    "the CPU. Exit 1 when a hash, a counter or an output differs, when a call is refused on one side only, or when a\n"
    "process crashes or hangs. A seed ends early if its batch is refused, or a call has no counterpart for a world "
    "alone.\n"
    "  --device NAME   of the batches: cpu (default), opencl, opencl:NAME\n"
    "  --seed N        first seed (0)\n"
    "  --seeds N       how many (100)\n"
    "  --seconds S     after which no more are begun (0: no end)\n"
    "  --jobs N        processes (1)\n"
    "  --lanes N       of all batches on a CPU (0: random)\n"
    "  --limit S       seconds that a seed may take (120)\n"
    "  --show          prints all calls\n";

typedef struct
{
	Setting setting;
	uint64_t seed;
	int seeds, jobs;
	double seconds, limit; // s
} Options;

typedef struct // sums of a process
{
	Progress progress;
	Counts counts;
} Sums;

static void die(const char* format, const char* what)
{
	fprintf(stderr, format, what);
	fputs(usage, stderr);
	exit(2);
}

static Options parse(int count, char** arguments)
{
	Options o = {.setting = {.device = "cpu"}, .seeds = 100, .jobs = 1, .limit = 120.0};
	for (int k = 1; k < count; ++k)
	{
		const char* name = arguments[k];
		if (strcmp(name, "--help") == 0)
		{
			fputs(usage, stdout);
			exit(0);
		}
		if (strcmp(name, "--show") == 0)
		{
			o.setting.shows = true;
			continue;
		}
		if (k + 1 == count)
			die("mirror: %s: no such option, or its value is missing\n", name);
		const char* value = arguments[++k];
		char* end = NULL;
		double number = strtod(value, &end);
		if (strcmp(name, "--device") == 0)
		{
			o.setting.device = value;
			continue;
		}
		if (end == value || *end || number < 0.0 || number > 1e15)
			die("mirror: %s is no number\n", value);
		if (strcmp(name, "--seed") == 0)
			o.seed = (uint64_t)number;
		else if (strcmp(name, "--seeds") == 0)
			o.seeds = (int)number;
		else if (strcmp(name, "--seconds") == 0)
			o.seconds = number;
		else if (strcmp(name, "--jobs") == 0)
			o.jobs = number < 1.0 ? 1 : number > MOST_JOBS ? MOST_JOBS : (int)number;
		else if (strcmp(name, "--lanes") == 0)
			o.setting.lanes = (int)number;
		else if (strcmp(name, "--limit") == 0)
			o.limit = number;
		else
			die("mirror: there is no option %s\n", name);
	}
	return o;
}

static void work(const void* options, int job, int jobs, void* sums)
{
	const Options* o = options;
	Sums* s = sums;
	double begin = seconds_now();
	scree_batch* kept = NULL;
	if (strcmp(o->setting.device, "cpu") != 0)
		must(batch_keep(o->setting.device, &kept));
	for (int k = job; k < o->seeds && (o->seconds <= 0.0 || seconds_now() - begin < o->seconds); k += jobs)
	{
		s->progress.since = seconds_now();
		s->progress.seed = o->seed + (uint64_t)k;
		mirror_run(&o->setting, s->progress.seed, &s->counts);
	}
	scree_batch_destroy(kept);
	s->progress.finished = true;
}

static void report(const void* options, uint64_t seed, bool late, int status)
{
	const Options* o = options;
	printf("seed %" PRIu64 ": %s (status %d); again: mirror --device %s --seed %" PRIu64
	       " --seeds 1 --lanes %d --show\n",
	       seed, late ? "it hangs" : "the process crashed", status, o->setting.device, seed, o->setting.lanes);
}

static void add(void* all, const void* sums)
{
	Counts* to = &((Sums*)all)->counts;
	const Sums* from = sums;
	const Counts* c = &from->counts;
	to->seeds += c->seeds;
	to->ended += c->ended;
	to->batches += c->batches;
	to->frozen += c->frozen;
	to->steps += c->steps;
	to->compared += c->compared;
	to->hash += c->hash;
	to->faults += c->faults + from->progress.failed;
}

int main(int count, char** arguments)
{
	Options o = parse(count, arguments);
	const Jobs jobs = {&o, o.jobs, o.limit, sizeof(Sums), work, report, add};
	Sums all = {.progress = {.seed = 0}};
	double begin = seconds_now();
	if (pair_hide_log() != SCREE_OK || !jobs_run(&jobs, &all))
	{
		fprintf(stderr, "mirror: no memory for %d processes\n", o.jobs);
		return 2;
	}
	const Counts* c = &all.counts;
	printf("%s: %d seeds, %d ended early, %d batches, %" PRId64 " steps, %" PRId64
	       " worlds compared, %d bodies frozen, "
	       "%d faults, hash %016" PRIx64 ", %.1f s\n",
	       o.setting.device, c->seeds, c->ended, c->batches, c->steps, c->compared, c->frozen, c->faults, c->hash,
	       seconds_now() - begin);
	return c->faults > 0;
}
