// SPDX-License-Identifier: MIT
// main.c -- the command "programs": runs random programs on a device and on the reference, or repeats one program.
#include "programs/farm.h"
#include "support/form_names.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: programs [OPTION...]\n"
    "Random programs of calls run on two worlds: on the CPU with one thread and one lane, and on another device. Exit "
    "1\n"
    "when a status, an answer or a hash of any differs, when a process crashes or hangs, or when a state is not "
    "finite.\n"
    "  --programs N    how many (100)\n"
    "  --seed N        of the first (0)\n"
    "  --calls N       of each (200)\n"
    "  --device NAME   where they run: cpu (default), opencl, opencl:NAME\n"
    "  --form NAME     of the solve there: default, launches, relay, tiles (docs/design/opencl.md); with \",own\" or\n"
    "                  \",worse\" after it, quotients and roots are rounded by integers (src/dialect/own_rounding.h);\n"
    "                  with \",flush\" at the end, denormals count as 0 there (src/backend/arithmetic.h)\n"
    "  --threads N, --lanes N   on a CPU (0: all)\n"
    "  --jobs N        processes (1)\n"
    "  --life N        programs, one after the other, on the same worlds, up to 64 (1)\n"
    "  --every N       steps after which hashes are compared (1)\n"
    "  --reports N     failures that a process makes shorter and prints; the others it counts (4)\n"
    "  --infinite      state that is not finite is no failure\n"
    "  --reads         the other world is read between calls, and moved to the device where it is\n"
    "  --batches       after each step the other world is copied into a batch, whose worlds are compared with it\n"
    "  --faults        the device of the other world fails between calls: docs/design/faults.md\n"
    "  --records       the calls of each program are recorded, and repeated on the device at the end "
    "(docs/manual/recording.md)\n"
    "  --record FILE   the same; the last recording is written to the file\n"
    "  --limits        a body that exceeds max_speed after a step is a failure, and one that turns too fast\n"
    "  --shrink S      seconds to make a program that fails shorter (20; 0 with --replay)\n"
    "  --seconds S     after which no more are begun (0: no end)\n"
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
		bool* flag = strcmp(name, "--show") == 0       ? &o.shown
		             : strcmp(name, "--infinite") == 0 ? &o.infinite
		             : strcmp(name, "--limits") == 0   ? &o.limits
		             : strcmp(name, "--reads") == 0    ? &o.places[1].reads
		             : strcmp(name, "--batches") == 0  ? &o.places[1].batches
		             : strcmp(name, "--faults") == 0   ? &o.places[1].faults
		             : strcmp(name, "--records") == 0  ? &o.records
		                                               : NULL;
		if (flag)
		{
			*flag = true;
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
		const char* texts[] = {"--device", "--form", "--out", "--replay", "--record"};
		bool text = false;
		for (int i = 0; i < 5; ++i)
			text |= strcmp(name, texts[i]) == 0;
		if (!text && (end == value || *end || number < 0.0 || number > 1e15))
			die("programs: %s is no number\n", value);
		if (strcmp(name, "--device") == 0)
			snprintf(o.places[1].device, sizeof o.places[1].device, "%s", value);
		else if (strcmp(name, "--form") == 0)
		{
			if (!form_choose(value))
				die("programs: there is no form %s\n", value);
			o.places[1].flush = arithmetic_setting.flush;
		}
		else if (strcmp(name, "--out") == 0)
			o.out = value;
		else if (strcmp(name, "--replay") == 0)
			o.replay = value;
		else if (strcmp(name, "--record") == 0)
		{
			o.record = value;
			o.records = true;
		}
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
		else if (strcmp(name, "--every") == 0)
			o.every = (int)number;
		else if (strcmp(name, "--seconds") == 0)
			o.seconds = number;
		else if (strcmp(name, "--limit") == 0)
			o.limit = number;
		else
			die("programs: there is no option %s\n", name);
	}
	if (strcmp(o.places[1].device, "cpu") != 0)
		snprintf(o.places[1].other, sizeof o.places[1].other, "cpu");
	return o;
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
	pair.limits = o->limits;
	pair.records = o->records;
	pair.record_path = o->record;
	if (o->shrink > 0.0 && farm_shrink(&pair, &program, o->shrink))
		program_write(&program, stdout);
	bool differs = farm_print(&pair, &program, o->replay, stdout);
	bool chooses = o->places[1].reads || o->places[1].faults;
	for (pair.first_read = 1; chooses && !differs && pair.first_read < READ_CHOICES; ++pair.first_read)
		differs = farm_print(&pair, &program, o->replay, stdout);
	if (!differs)
		printf("%s: the same on both\n", o->replay);
	pair_close(&pair);
	program_close(&program);
	return differs;
}

int main(int count, char** arguments)
{
	Options o = parse(count, arguments);
	pair_hide_log();
	if (o.replay)
		return replay(&o);
	o.shrink = o.shrink < 0.0 ? 20.0 : o.shrink;
	if (!o.shown)
		return farm_run(&o);
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
