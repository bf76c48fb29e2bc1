// SPDX-License-Identifier: MIT
// main.c -- the command "programs": random programs on a device beside the reference, by many processes at once.
//
// A process that crashes or hangs has written before each program which one it is at, so that its parent can say so.
#define _DEFAULT_SOURCE
#include "clock.h"
#include "programs/program.h"
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#define MOST_JOBS 64

typedef struct
{
	int programs, calls, jobs, life, reports;
	bool shown, infinite;
	uint64_t seed;
	double shrink, limit; // s
	const char *out, *replay;
	Place places[2];
} Options;

typedef struct // what a process says of itself; shared with its parent
{
	uint64_t seed;
	double since; // ms by the clock
	int done, failed, steps, frozen;
	bool finished;
} Desk;

static const char usage[] =
    "usage: programs [OPTION...]\n"
    "Random programs of calls run on two worlds: on the CPU with one thread and one lane, and on another device. Exit "
    "1\n"
    "when a status, an answer or a hash of any differs, when a process crashes or hangs, or when a state is not "
    "finite.\n"
    "  --programs N    how many (100)\n"
    "  --seed N        of the first (0)\n"
    "  --calls N       of each (200)\n"
    "  --device NAME   where they run: cpu (default), opencl, opencl:NAME; the environment chooses forms "
    "(docs/opencl.md)\n"
    "  --threads N, --lanes N   on a CPU (0: all)\n"
    "  --jobs N        processes (1)\n"
    "  --life N        programs, one after the other, on the same worlds, up to 16 (1)\n"
    "  --reports N     failures that a process makes shorter and prints; the others it counts (4)\n"
    "  --infinite      state that is not finite is no failure\n"
    "  --shrink S      seconds to make a program that fails shorter (20; 0 with --replay)\n"
    "  --limit S       seconds that a program may take (120)\n"
    "  --out FOLDER    where programs that fail are written (.)\n"
    "  --show          writes the programs, and runs none\n"
    "  --replay FILE   runs the program in this file instead\n";

static void die(const char* format, const char* what)
{
	fprintf(stderr, format, what);
	fputs(usage, stderr);
	exit(2);
}

static Options parse(int count, char** arguments)
{
	Options o = {
	    .programs = 100, .calls = 200, .jobs = 1, .life = 1, .reports = 4, .shrink = -1.0, .limit = 120.0, .out = "."};
	o.places[0] = (Place){.device = "cpu", .threads = 1, .lanes = 1};
	o.places[1] = (Place){.device = "cpu"};
	for (int k = 1; k < count; ++k)
	{
		const char* name = arguments[k];
		if (strcmp(name, "--show") == 0 || strcmp(name, "--infinite") == 0)
		{
			*(name[2] == 's' ? &o.shown : &o.infinite) = true;
			continue;
		}
		if (strcmp(name, "--help") == 0)
		{
			fputs(usage, stdout);
			exit(0);
		}
		if (k + 1 == count)
			die("programs: %s: no such option, or its value is missing\n", name);
		const char* value = arguments[++k];
		char* end = NULL;
		double number = strtod(value, &end);
		const char* texts[] = {"--device", "--out", "--replay"};
		bool text = false;
		for (int i = 0; i < 3; ++i)
			text |= strcmp(name, texts[i]) == 0;
		if (!text && (end == value || *end || number < 0.0 || number > 1e15))
			die("programs: %s is no number\n", value);
		if (strcmp(name, "--device") == 0)
			snprintf(o.places[1].device, sizeof o.places[1].device, "%s", value);
		else if (strcmp(name, "--out") == 0)
			o.out = value;
		else if (strcmp(name, "--replay") == 0)
			o.replay = value;
		else if (strcmp(name, "--programs") == 0)
			o.programs = (int)number;
		else if (strcmp(name, "--seed") == 0)
			o.seed = (uint64_t)number;
		else if (strcmp(name, "--calls") == 0)
			o.calls = (int)number;
		else if (strcmp(name, "--threads") == 0)
			o.places[1].threads = (int)number;
		else if (strcmp(name, "--lanes") == 0)
			o.places[1].lanes = (int)number;
		else if (strcmp(name, "--reports") == 0)
			o.reports = (int)number;
		else if (strcmp(name, "--jobs") == 0)
			o.jobs = number < 1.0 ? 1 : number > MOST_JOBS ? MOST_JOBS : (int)number;
		else if (strcmp(name, "--life") == 0)
			o.life = number < 1.0 ? 1 : number > PROGRAM_BLOCK ? PROGRAM_BLOCK : (int)number;
		else if (strcmp(name, "--shrink") == 0)
			o.shrink = number;
		else if (strcmp(name, "--limit") == 0)
			o.limit = number;
		else
			die("programs: there is no option %s\n", name);
	}
	if (strcmp(o.places[1].device, "cpu") != 0)
		snprintf(o.places[1].other, sizeof o.places[1].other, "cpu");
	return o;
}

static void quiet(scree_log_level level, const char* sentence, void* context)
{
	(void)level;
	(void)sentence;
	(void)context;
}

// Runs a program on worlds that are new and prints how it differs.
static bool tell(Pair* pair, const Program* program, const char* what, FILE* file)
{
	pair_forget(pair);
	Outcome outcome = pair_run(pair, program, file);
	pair_forget(pair);
	if (outcome.differs)
		fprintf(file, "%s: after call %d, %s: %s\n", what, outcome.call,
		        call_info(program->calls[outcome.call].kind)->name, outcome.sentence);
	return outcome.differs;
}

// The program in which worlds began to differ, made short and written to a file. before holds what ran on the same
// worlds before it.
static void report(const Options* o, Pair* pair, Program* program, const Program* before, uint64_t seed)
{
	char path[512], what[64];
	snprintf(what, sizeof what, "program %" PRIu64, seed);
	snprintf(path, sizeof path, "%s/program-%" PRIu64 ".txt", o->out, seed);
	Program whole = {0};
	bool found = pair_run(pair, program, NULL).differs;
	if (!found && before->count > 0)
	{
		program_copy(&whole, before);
		program_add(&whole, call_make(CALL_clear));
		for (int k = 1; k < program->count; ++k)
			program_add(&whole, program->calls[k]);
		program_copy(program, &whole);
		pair_forget(pair);
		found = pair_run(pair, program, NULL).differs;
	}
	if (found)
		program_shrink(program, pair, o->shrink);
	char* text = NULL;
	size_t length = 0;
	FILE* memory = open_memstream(&text, &length);
	if (memory)
	{
		if (!tell(pair, program, what, memory))
			fprintf(memory, "%s: differed, and does not when run again\n", what);
		program_write(program, memory);
		fprintf(memory, "again: programs --device %s --replay %s\n\n", o->places[1].device, path);
		fclose(memory);
		fwrite(text, 1, length, stdout);
		fflush(stdout);
		free(text);
	}
	FILE* file = fopen(path, "w");
	if (file)
	{
		program_write(program, file);
		fclose(file);
	}
	program_close(&whole);
}

static void work(const Options* o, int job, Desk* desk)
{
	Pair pair;
	Program program = {0}, before = {0};
	pair_open(&pair, o->places);
	pair.infinite = o->infinite;
	int lives = (o->programs + o->life - 1) / o->life, reports = 0;
	for (int life = job; life < lives; life += o->jobs)
	{
		before.count = 0;
		pair_forget(&pair);
		for (int k = life * o->life; k < (life + 1) * o->life && k < o->programs; ++k)
		{
			uint64_t seed = o->seed + (uint64_t)k;
			desk->since = clock_milliseconds();
			desk->seed = seed;
			program_make(&program, seed, o->calls);
			Outcome outcome = pair_run(&pair, &program, NULL);
			desk->steps += outcome.steps;
			desk->frozen += outcome.frozen;
			desk->done += 1;
			if (outcome.differs)
			{
				desk->failed += 1;
				desk->since = clock_milliseconds() + 2e3 * o->shrink;
				if (reports++ < o->reports)
					report(o, &pair, &program, &before, seed);
				pair_forget(&pair);
				before.count = 0;
				continue;
			}
			for (int i = before.count > 0; i < program.count; ++i)
			{
				if (i == 1 && before.count > 1)
					program_add(&before, call_make(CALL_clear));
				program_add(&before, program.calls[i]);
			}
		}
	}
	pair_close(&pair);
	program_close(&program);
	program_close(&before);
	desk->finished = true;
}

static int run_all(const Options* o)
{
	Desk* desks = mmap(NULL, MOST_JOBS * sizeof *desks, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	pid_t children[MOST_JOBS] = {0};
	if (desks == MAP_FAILED)
		die("programs: no memory for %s\n", "the processes");
	double begin = clock_milliseconds();
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
	int done = 0, failed = 0, steps = 0, frozen = 0;
	for (int left = o->jobs; left > 0;)
	{
		usleep(20000);
		for (int k = 0; k < o->jobs; ++k)
		{
			int status;
			if (children[k] <= 0)
				continue;
			bool late = !desks[k].finished && clock_milliseconds() - desks[k].since > 1000.0 * o->limit;
			if (late)
				kill(children[k], SIGKILL);
			if (waitpid(children[k], &status, late ? 0 : WNOHANG) != children[k])
				continue;
			children[k] = 0;
			--left;
			if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
				continue;
			++failed;
			printf("program %" PRIu64 ": %s (status %d); again: programs --seed %" PRIu64
			       " --programs 1 --calls %d --device %s\n",
			       desks[k].seed, late ? "it hangs" : "the process crashed", status, desks[k].seed, o->calls,
			       o->places[1].device);
		}
	}
	for (int k = 0; k < o->jobs; ++k)
	{
		done += desks[k].done;
		failed += desks[k].failed;
		steps += desks[k].steps;
		frozen += desks[k].frozen;
	}
	printf("%s: %d programs, %d steps, %d bodies frozen, %d failures, %.1f s\n", o->places[1].device, done, steps,
	       frozen, failed, 1e-3 * (clock_milliseconds() - begin));
	return failed > 0;
}

static int replay(const Options* o)
{
	char error[256];
	Program program = {0};
	FILE* file = fopen(o->replay, "r");
	if (!file)
		die("programs: cannot open %s\n", o->replay);
	if (!program_read(&program, file, error))
	{
		fprintf(stderr, "programs: %s: %s\n", o->replay, error);
		return 2;
	}
	fclose(file);
	Pair pair;
	pair_open(&pair, o->places);
	pair.infinite = o->infinite;
	if (o->shrink > 0.0 && pair_run(&pair, &program, NULL).differs)
	{
		program_shrink(&program, &pair, o->shrink);
		program_write(&program, stdout);
	}
	bool differs = tell(&pair, &program, o->replay, stdout);
	if (!differs)
		printf("%s: the same on both\n", o->replay);
	pair_close(&pair);
	program_close(&program);
	return differs;
}

int main(int count, char** arguments)
{
	Options o = parse(count, arguments);
	const scree_hooks hooks = {.log = quiet};
	scree_set_hooks(&hooks);
	if (o.replay)
		return replay(&o);
	o.shrink = o.shrink < 0.0 ? 20.0 : o.shrink;
	if (!o.shown)
		return run_all(&o);
	Program program = {0};
	for (int k = 0; k < o.programs; ++k)
	{
		program_make(&program, o.seed + (uint64_t)k, o.calls);
		printf("# program %" PRIu64 "\n", o.seed + (uint64_t)k);
		program_write(&program, stdout);
	}
	program_close(&program);
	return 0;
}
