// SPDX-License-Identifier: MIT
// peers.c -- compares the speed of Scree and Box2D v3 with the same scenes, steps, substeps and threads.
//
// Each trial is a process, so that the engines do not share memory, threads or clock speed. The trials alternate, A B A
// B, because the speed of a machine changes. A ratio is computed from each pair of consecutive trials, and the
// median of the ratios is printed. Overlaps, contacts and final states come from trials that are not timed. A timed
// trial must end in the same state.
#include "engine_box2d.h"
#include "peer_queries.h"
#include "peer_validate.h"
#include "process.h"
#include "stiffness.h"
#include "tools/common/median.h"
#include "trial.h"
#include "validate/engine_scree.h"
#include <getopt.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define MAX_SETTINGS 16
#define MAX_THREADS  16 // maximum number of entries of --threads
#define MAX_REPEATS  101
#define MAX_SCENES   100
#define MAX_WORDS    64

typedef struct
{
	const char* executable;
	const Engine* engine; // engine of a trial; null in the process that starts the trials
	bool measured;
	EngineOptions options;
	int threads[MAX_THREADS], thread_count;
	int steps, repeats; // steps: 0 stands for the number of steps in the scene
	const char* settings[MAX_SETTINGS];
	int setting_count;
} Options;

static const struct option words[] = {
    {"threads", required_argument, NULL, 't'},
    {"steps", required_argument, NULL, 'n'},
    {"repeats", required_argument, NULL, 'r'},
    {"device", required_argument, NULL, 'd'},
    {"set", required_argument, NULL, 's'},
    {"continuous", no_argument, NULL, 'c'},
    {"help", no_argument, NULL, 'h'},
    {"engine", required_argument, NULL, 'e'},
    {"ruled", no_argument, NULL, 'R'},
    {"sleep", no_argument, NULL, 'S'},
    {0},
};

static const char* const help =
    "usage: scree_peers [OPTION]... [SCENE|FILE]...\n"
    "       scree_peers validate --help\n"
    "       scree_peers stiffness --help\n"
    "\n"
    "Times scenes with Scree and with Box2D in turns; CSV on standard output. Without a name: pyramid, pyramids, "
    "pile,\n"
    "tumbler, smash, washer. A ratio above 1 means that Scree is the faster one. Scenes with joints, made by code:\n"
    "joint_grid, rain, spinner, drum, ropes, bridges, beam, humans, car.\n"
    "\n"
    "  -t, --threads N[,N]...   threads of both, 1,2 without it\n"
    "  -n, --steps N            steps to take; without it as many as the scene says\n"
    "  -r, --repeats N          pairs of timed trials, 5 without it\n"
    "  -d, --device NAME        where Scree runs, cpu without it\n"
    "  -c, --continuous         Box2D with continuous collision\n"
    "  -S, --sleep              bodies at rest fall asleep in both engines\n"
    "  -s, --set NAME=VALUE     give a parameter of the scenes another value; may be repeated\n"
    "  -e, --engine NAME        one trial alone, of scree or box2d: ms a step, median ms, ms of the first 150, deepest "
    "overlap of all\n"
    "                           steps, mean of the deepest of each, mean contacts, sink, largest and mean\n"
    "                           separation of joints, awake bodies, step since which all sleep, final state\n"
    "  -R, --ruled              that trial is not timed but measured with the ruler\n"
    "  -h, --help               this text\n";

static bool read_int(const char* name, const char* text, int high, int* number)
{
	char* end;
	long value = strtol(text, &end, 10);
	if (end != text && *end == 0 && value >= 1 && value <= high)
	{
		*number = (int)value;
		return true;
	}
	fprintf(stderr, "scree_peers: --%s %s: must be a whole number from 1 to %d\n", name, text, high);
	return false;
}

static bool read_threads(Options* options, char* list)
{
	options->thread_count = 0;
	for (char* word = strtok(list, ","); word; word = strtok(NULL, ","))
	{
		if (options->thread_count == MAX_THREADS ||
		    !read_int("threads", word, 64, &options->threads[options->thread_count]))
			return false;
		++options->thread_count;
	}
	return options->thread_count > 0;
}

static bool read_engine(Options* options, const char* name)
{
	options->engine = strcmp(name, "scree") == 0 ? &scree_engine : strcmp(name, "box2d") == 0 ? &box2d_engine : NULL;
	if (!options->engine)
		fprintf(stderr, "scree_peers: --engine %s: must be scree or box2d\n", name);
	return options->engine;
}

static bool read_option(Options* options, int letter)
{
	switch (letter)
	{
	case 't':
		return read_threads(options, optarg);
	case 'n':
		return read_int("steps", optarg, 1000000, &options->steps);
	case 'r':
		return read_int("repeats", optarg, MAX_REPEATS, &options->repeats);
	case 'd':
		options->options.device = optarg;
		return true;
	case 's':
		if (options->setting_count == MAX_SETTINGS || !strchr(optarg, '='))
			return fprintf(stderr, "scree_peers: --set %s: must be NAME=VALUE, at most %d times\n", optarg,
			               MAX_SETTINGS) < 0;
		options->settings[options->setting_count++] = optarg;
		return true;
	case 'c':
		options->options.continuous = true;
		return true;
	case 'S':
		options->options.sleep = true;
		return true;
	case 'e':
		return read_engine(options, optarg);
	case 'R':
		options->measured = true;
		return true;
	case 'h':
		printf("%s", help);
		exit(EXIT_GOOD);
	default:
		return false;
	}
}

static bool load(const Options* options, const char* name, Setup* setup)
{
	char names[MAX_SETTINGS][64];
	SceneSetting settings[MAX_SETTINGS];
	for (int k = 0; k < options->setting_count; ++k)
	{
		const char* value = strchr(options->settings[k], '=');
		snprintf(names[k], sizeof names[k], "%.*s", (int)(value - options->settings[k]), options->settings[k]);
		settings[k] = (SceneSetting){names[k], value + 1};
	}
	return setup_load(setup, name, options->executable, settings, options->setting_count);
}

// Runs one trial in this process and prints its result. Returns an exit code.
static int try_engine(const Options* options, const char* name)
{
	Setup setup;
	if (!load(options, name, &setup))
		return EXIT_BAD;
	Trial trial = {&setup, options->steps > 0 ? options->steps : setup.steps, options->measured, options->options};
	Result result;
	bool good = trial_run(options->engine, &trial, &result);
	if (good)
		result_print(&result);
	setup_free(&setup);
	return good ? EXIT_GOOD : EXIT_FAILED;
}

// Runs one trial in a new process and reads its result. Returns false if it failed.
static bool start_trial(const Options* options, const char* name, const Engine* engine, int threads, bool measured,
                        Result* result)
{
	char count[16], steps[16], line[256];
	snprintf(count, sizeof count, "%d", threads);
	snprintf(steps, sizeof steps, "%d", options->steps);
	const char* list[MAX_WORDS] = {options->executable,    "--engine", engine->name, "--threads", count, "--device",
	                               options->options.device};
	int n = 7;
	if (options->steps > 0)
	{
		list[n++] = "--steps";
		list[n++] = steps;
	}
	if (measured)
		list[n++] = "--ruled";
	if (options->options.continuous)
		list[n++] = "--continuous";
	if (options->options.sleep)
		list[n++] = "--sleep";
	for (int k = 0; k < options->setting_count; ++k)
	{
		list[n++] = "--set";
		list[n++] = options->settings[k];
	}
	list[n++] = "--";
	list[n++] = name;
	list[n] = NULL;
	return process_run((char* const*)list, line, sizeof line) == EXIT_GOOD && result_scan(line, result);
}

typedef enum
{
	SCREE,
	BOX2D,
	ENGINES
} Side;

static const Engine* const engines[ENGINES] = {&scree_engine, &box2d_engine};

static bool compare(const Options* options, const char* name, int steps, int threads, const Result measured[ENGINES])
{
	double mean[ENGINES][MAX_REPEATS], median[ENGINES][MAX_REPEATS], first[ENGINES][MAX_REPEATS];
	double ratio[MAX_REPEATS], first_ratio[MAX_REPEATS];
	bool same = true;
	for (int k = 0; k < options->repeats; ++k)
	{
		for (int side = SCREE; side < ENGINES; ++side)
		{
			Result result;
			if (!start_trial(options, name, engines[side], threads, false, &result))
				return false;
			mean[side][k] = result.mean;
			median[side][k] = result.median;
			first[side][k] = result.first;
			same = same && result.hash == measured[side].hash;
		}
		ratio[k] = mean[BOX2D][k] / mean[SCREE][k];
		first_ratio[k] = first[BOX2D][k] / first[SCREE][k];
	}
	printf("%s,%d,%d,%d,%d,%.4f,%.4f,%.3f", name, threads, steps, options->options.continuous, options->options.sleep,
	       upper_median_of(mean[SCREE], options->repeats), upper_median_of(mean[BOX2D], options->repeats),
	       upper_median_of(ratio, options->repeats));
	printf(",%.3f,%.3f", ratio[0],
	       ratio[options->repeats - 1]); // smallest and largest ratio, because upper_median_of has sorted them
	printf(",%.4f,%.4f,%.3f", upper_median_of(first[SCREE], options->repeats),
	       upper_median_of(first[BOX2D], options->repeats), upper_median_of(first_ratio, options->repeats));
	printf(",%.4f,%.4f", upper_median_of(median[SCREE], options->repeats),
	       upper_median_of(median[BOX2D], options->repeats));
	const Result *a = &measured[SCREE], *b = &measured[BOX2D];
	printf(",%.5f,%.5f,%.5f,%.5f", (double)a->penetration, (double)b->penetration, (double)a->depth, (double)b->depth);
	printf(",%.0f,%.0f,%.5f,%.5f", (double)a->contacts, (double)b->contacts, (double)a->sunk, (double)b->sunk);
	printf(",%.5f,%.5f,%.7f,%.7f", (double)a->separation, (double)b->separation, (double)a->gap, (double)b->gap);
	printf(",%d,%d,%d,%d", a->awake, b->awake, a->rested, b->rested);
	printf(",%016" PRIx64 ",%016" PRIx64 ",%d\n", a->hash, b->hash, same);
	fflush(stdout);
	return true;
}

static bool compare_all(const Options* options, const char* name, int steps)
{
	// the final states of both engines do not depend on the number of threads, so one measured trial per engine is
	// enough
	Result measured[ENGINES];
	bool good = true;
	int threads = options->threads[options->thread_count - 1];
	for (int side = SCREE; side < ENGINES && good; ++side)
		good = start_trial(options, name, engines[side], threads, true, &measured[side]);
	for (int k = 0; k < options->thread_count && good; ++k)
		good = compare(options, name, steps, options->threads[k], measured);
	return good;
}

int main(int count, char** arguments)
{
	static const char* const usual[] = {"pyramid", "pyramids", "pile", "tumbler", "smash", "washer"};
	if (count > 1 && strcmp(arguments[1], "validate") == 0)
		return validate_peers(count - 1, arguments + 1, arguments[0]);
	if (count > 1 && strcmp(arguments[1], "stiffness") == 0)
		return stiffness_peers(count - 1, arguments + 1, arguments[0]);
	if (count > 1 && strcmp(arguments[1], "queries") == 0)
		return queries_peers(count - 1, arguments + 1);
	Options options = {.executable = arguments[0], .threads = {1, 2}, .thread_count = 2, .repeats = 5};
	options.options.device = "cpu";
	for (int letter; (letter = getopt_long(count, arguments, "t:n:r:d:s:cSe:Rh", words, NULL)) != -1;)
	{
		if (!read_option(&options, letter))
			return EXIT_BAD;
	}
	const char* const* names = optind < count ? (const char* const*)arguments + optind : usual;
	int name_count = optind < count ? count - optind : (int)(sizeof usual / sizeof usual[0]);
	if (options.engine)
	{
		options.options.threads = options.threads[0];
		return try_engine(&options, names[0]);
	}
	// loads all scenes before the first trial, so that an error in any of them is found at once
	int steps[MAX_SCENES];
	for (int k = 0; k < name_count; ++k)
	{
		Setup setup;
		if (k >= MAX_SCENES || !load(&options, names[k], &setup))
			return EXIT_BAD;
		steps[k] = options.steps > 0 ? options.steps : setup.steps;
		setup_free(&setup);
	}
	printf("scene,threads,steps,continuous,sleep,ms_scree,ms_box2d,ratio,ratio_least,ratio_most,"
	       "first_scree,first_box2d,first_ratio,median_scree,median_box2d,"
	       "penetration_scree,penetration_box2d,depth_scree,depth_box2d,contacts_scree,contacts_box2d,sink_scree,"
	       "sink_box2d,separation_scree,separation_box2d,gap_scree,gap_box2d,awake_scree,awake_box2d,rested_scree,"
	       "rested_box2d,hash_scree,hash_box2d,same\n");
	for (int k = 0; k < name_count; ++k)
	{
		if (!compare_all(&options, names[k], steps[k]))
			return EXIT_FAILED;
	}
	return EXIT_GOOD;
}
