// SPDX-License-Identifier: MIT
// sleep_bench.c -- scree_sleep: measures the cost of sleeping bodies, and of steps that wake them (docs/measurements/sleep.md).
#include "sleep_cases.h"
#include "sleep_rows.h"
#include "sleep_trial.h"
#include "sleep_worlds.h"
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

#define EXIT_LINE 2  // exit code of a bad command line
#define MAX_NAMED 64 // maximum number of --case

typedef struct
{
	SleepSetting setting;
	const SleepCase* named[MAX_NAMED];
	int named_count;
	bool csv;
} Line;

static const struct option words[] = {
    {"device", required_argument, NULL, 'd'},   {"threads", required_argument, NULL, 't'},
    {"lanes", required_argument, NULL, 'l'},    {"case", required_argument, NULL, 'k'},
    {"sleepers", required_argument, NULL, 'b'}, {"awake", required_argument, NULL, 'a'},
    {"rows", required_argument, NULL, 'R'},     {"steps", required_argument, NULL, 'n'},
    {"repeats", required_argument, NULL, 'r'},  {"csv", no_argument, NULL, 'c'},
    {"help", no_argument, NULL, 'h'},           {0},
};

static const char* const help =
    "usage: scree_sleep [OPTION]...\n"
    "\n"
    "Measures steps beside sleeping bodies and steps that wake bodies. Each row has the hash, the contacts, the "
    "sleeping\n"
    "bodies and the deepest overlap of the run. Exit 1 if a row is not valid.\n"
    "\n"
    "  -d, --device NAME    device as in scree_world_def, cpu without it\n"
    "  -t, --threads N      threads of the CPU; without it one per core\n"
    "  -l, --lanes N        lanes of the CPU: 1, 4, 8 or 16; without it the most that there are\n"
    "  -k, --case NAME      a case of the list below; may be repeated\n"
    "  -b, --sleepers N     sleeping bodies, rounded up to pyramids of 55; 990000 without it, 9955000 in ball\n"
    "  -a, --awake N        awake bodies of part, balls and awake; 1 % of all without it\n"
    "  -R, --rows N         rows of the pyramid of wake-created and so on, 100 without it\n"
    "  -n, --steps N        timed steps of a run, 60 without it; always 28 in wake-created and so on\n"
    "  -r, --repeats N      timed runs of each world, 3 without it\n"
    "  -c, --csv            CSV on standard output; without it a list of names and values\n"
    "  -h, --help           this text\n"
    "\n"
    "Cases; without --case all but ball:\n";

static void print_help(void)
{
	printf("%s", help);
	for (int k = 0; k < sleep_case_count; ++k)
		printf("  %-14s %s\n", sleep_cases[k].name, sleep_cases[k].about);
}

static bool read_number(const char* name, int most, int* number)
{
	char* end;
	long value = strtol(optarg, &end, 10);
	if (end != optarg && *end == 0 && value >= 1 && value <= most)
	{
		*number = (int)value;
		return true;
	}
	fprintf(stderr, "scree_sleep: --%s %s: must be a whole number from 1 to %d\n", name, optarg, most);
	return false;
}

static bool read_case(Line* line)
{
	const SleepCase* item = sleep_case_find(optarg);
	if (!item || line->named_count == MAX_NAMED)
	{
		fprintf(stderr, "scree_sleep: --case %s: must be a case that scree_sleep --help lists, at most %d times\n",
		        optarg, MAX_NAMED);
		return false;
	}
	line->named[line->named_count++] = item;
	return true;
}

static bool read_option(Line* line, int letter)
{
	SleepSetting* setting = &line->setting;
	switch (letter)
	{
	case 'd':
		setting->place.device = optarg;
		return true;
	case 't':
		return read_number("threads", 64, &setting->place.threads);
	case 'l':
		return read_number("lanes", 16, &setting->place.lanes);
	case 'k':
		return read_case(line);
	case 'b':
		return read_number("sleepers", 16000000, &setting->sleepers);
	case 'a':
		return read_number("awake", 16000000, &setting->awake);
	case 'R':
		return read_number("rows", MAX_ROWS, &setting->rows);
	case 'n':
		return read_number("steps", MAX_STEPS, &setting->steps);
	case 'r':
		return read_number("repeats", MAX_REPEATS, &setting->repeats);
	case 'c':
		line->csv = true;
		return true;
	case 'h':
		print_help();
		exit(EXIT_SUCCESS);
	default:
		return false;
	}
}

// Selects all cases that run without --case.
static void name_usual(Line* line)
{
	for (int k = 0; k < sleep_case_count; ++k)
	{
		if (!sleep_cases[k].large)
			line->named[line->named_count++] = &sleep_cases[k];
	}
}

int main(int count, char** arguments)
{
	Line line = {.setting = {.place = {.device = "cpu"}, .rows = 100, .steps = 60, .repeats = 3}};
	for (int letter; (letter = getopt_long(count, arguments, "d:t:l:k:b:a:R:n:r:ch", words, NULL)) != -1;)
	{
		if (!read_option(&line, letter))
			return EXIT_LINE;
	}
	if (optind < count)
	{
		fprintf(stderr, "scree_sleep: unexpected argument %s; --case names a case\n", arguments[optind]);
		return EXIT_LINE;
	}
	bool valid = true;
	if (line.named_count == 0)
		name_usual(&line);
	if (line.csv)
		sleep_rows_heading();
	for (int k = 0; k < line.named_count; ++k)
	{
		if (!sleep_rows_measure(line.named[k], &line.setting, line.csv, &valid))
			return EXIT_FAILURE;
	}
	return valid ? EXIT_SUCCESS : EXIT_FAILURE;
}
