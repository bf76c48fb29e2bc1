// SPDX-License-Identifier: MIT
// options.c -- reading the command line, and its help from the same table.
#include "options.h"
#include "commands.h"
#include <ctype.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#define WORLDS (RUN | HASH | BENCH | VIEW | FRAMES | FIGURE | VALIDATE) // commands that make worlds
#define ALL    (WORLDS | SCENES | DEVICES)

static const struct
{
	const char* name;
	char letter;
	const char* value; // null for a switch
	int commands;      // bits of Command
	const char* help;
} table[] = {
    {"steps", 'n', "N", RUN | HASH | BENCH | FRAMES | FIGURE, "steps to take; without it as many as the scene says"},
    {"device", 'd', "NAME", WORLDS, "auto, cpu, opencl, or opencl:NAME with part of a device's name"},
    {"threads", 't', "N", WORLDS, "CPU threads, 1 to 64; without it one a core"},
    {"lanes", 'l', "N", WORLDS, "CPU SIMD lanes: 1, 4, 8 or 16; without it the widest there is"},
    {"pipeline", 'P', "NAME", RUN | HASH | BENCH, "soft: the soft step solver; paper: the paper's, on one thread"},
    {"allow-unequal-bits", 'u', NULL, WORLDS, "use a device that cannot keep the promise of equal bits"},
    {"set", 's', "NAME=VALUE", WORLDS & ~(FIGURE | VALIDATE),
     "give a parameter of the scene another value; may be repeated"},
    {"picture", 'p', "FILE.png", RUN, "draw the end state"},
    {"video", 'v', "FILE.mp4", RUN, "60 frames a second of the world's time, through ffmpeg"},
    {"size", 'S', "WxH", RUN | FRAMES | VIEW, "pixels of picture, video, frames and window, 1600x900 without it"},
    {"renderer", 'R', "NAME", RUN, "of pictures and video: cairo, or gl, which draws on a GPU; cairo without it"},
    {"paint", 'a', "NAME", RUN | VIEW, "with gl: color bodies by attribute, speed or graph (colors of the solver)"},
    {"layers", 'L', "NAME,...", RUN | VIEW, "with gl: boxes, contacts, normals, impulses, velocities over the bodies"},
    {"script", 'x', "FILE", VIEW, "what a user would do, one thing a line: docs/view.md"},
    {"csv", 'c', "FILE.csv", RUN, "one row a step: counters and milliseconds"},
    {"repeats", 'r', "N", BENCH | FIGURE, "runs of each scene, 3 without it"},
    {"whole", 'w', NULL, BENCH, "time whole runs, the opening of the device included; see docs/auto.md"},
    {"known", 'k', "FILE.csv", BENCH, "rows of an earlier bench, whose hashes must come out again"},
    {"limit", 'm', "N", FIGURE, "most bodies, a million without it"},
    {"draw", 'D', "FILE.csv", FIGURE, "draw what an earlier bench measured"},
    {"names", 'N', NULL, SCENES | VALIDATE, "names alone, one a line"},
    {"quick", 'q', NULL, VALIDATE, "fewer and shorter runs: seconds, not minutes"},
    {"help", 'h', NULL, ALL, "this text"},
};
#define OPTION_COUNT (int)(sizeof table / sizeof table[0])

static const struct
{
	Command command;
	const char *name, *usage, *help;
} commands[] = {
    {RUN, "run", "run SCENE|FILE", "simulate, with a table of results at the end"},
    {VIEW, "view", "view [SCENE|FILE]", "open a window on a scene, pile without a name"},
    {HASH, "hash", "hash SCENE|FILE --steps N", "simulate and print the world's hash, 16 digits, alone"},
    {SCENES, "scenes", "scenes", "list the scenes with their parameters"},
    {DEVICES, "devices", "devices", "list the devices and whether they keep the promise of equal bits"},
    {BENCH, "bench", "bench [SCENE|FILE]...", "measure scenes (all without a name), CSV on standard output"},
    {FRAMES, "frames", "bench frames SCENE|FILE", "measure steps that are drawn: docs/share.md"},
    {FIGURE, "figures", "bench figure5|figure6", "measure and draw the paper's figures: docs/paper.md"},
    {VALIDATE, "validate", "validate [NAME]...", "experiments: whether what must hold does: docs/validate.md"},
};
#define COMMAND_COUNT (int)(sizeof commands / sizeof commands[0])

static const struct
{
	const char* name;
	PipelineChoice choice;
} pipelines[] = {{"soft", PIPELINE_SOFT}, {"paper", PIPELINE_PAPER}};
#define PIPELINE_COUNT (int)(sizeof pipelines / sizeof pipelines[0])

void print_help(FILE* file)
{
	fprintf(file, "scree %s -- 2D rigid bodies, the same bits on every device\n\n", scree_version());
	for (int k = 0; k < COMMAND_COUNT; ++k)
		fprintf(file, "  scree %-28s %s\n", commands[k].usage, commands[k].help);
	fprintf(file, "  scree %-28s %s\n", "help", "this text; --version prints the version");
	fprintf(file,
	        "\nscree COMMAND --help lists the options of a command.\n"
	        "\nA scene is a name from `scree scenes` or the path of a JSON file. SCREE_SCENES names another folder\n"
	        "to look in first. Exit codes: 0 done, 1 a device or a file failed, or a measurement is\n"
	        "invalid, 2 bad arguments or a bad scene.\n");
}

static void print_command_help(FILE* file, Command command)
{
	// bench is a command, and the first word of others
	for (int k = 0; k < COMMAND_COUNT; ++k)
	{
		if (commands[k].command == command || (command == BENCH && strncmp(commands[k].usage, "bench ", 6) == 0))
			fprintf(file, "  scree %-28s %s\n", commands[k].usage, commands[k].help);
	}
	fprintf(file, "\n");
	for (int k = 0; k < OPTION_COUNT; ++k)
	{
		char usage[64];
		snprintf(usage, sizeof usage, "--%s %s", table[k].name, table[k].value ? table[k].value : "");
		if (table[k].commands & command)
			fprintf(file, "  -%c, %-26s %s\n", table[k].letter, usage, table[k].help);
	}
	if (command == VIEW)
		print_view_help(file);
	if (command == VALIDATE)
		print_validate_help(file);
}

static bool read_int(const Options* options, const char* name, const char* text, int low, int high, int* number)
{
	char* end;
	long value = strtol(text, &end, 10);
	if (isdigit((unsigned char)*text) && !*end && value >= low && value <= high)
	{
		*number = (int)value;
		return true;
	}
	fprintf(stderr, "scree %s: --%s %s: must be a whole number from %d to %d\n", options->name, name, text, low, high);
	return false;
}

static bool read_lanes(Options* options, const char* text)
{
	static const char* const widths[] = {"1", "4", "8", "16"};
	for (int k = 0; k < 4; ++k)
	{
		if (strcmp(text, widths[k]) == 0)
		{
			options->lanes = atoi(text);
			return true;
		}
	}
	fprintf(stderr, "scree %s: --lanes %s: must be 1, 4, 8 or 16\n", options->name, text);
	return false;
}

static bool read_pipeline(Options* options, const char* text)
{
	for (int k = 0; k < PIPELINE_COUNT; ++k)
	{
		if (strcmp(text, pipelines[k].name) == 0)
		{
			options->pipeline = pipelines[k].choice;
			return true;
		}
	}
	fprintf(stderr, "scree %s: --pipeline %s: must be one of", options->name, text);
	for (int k = 0; k < PIPELINE_COUNT; ++k)
		fprintf(stderr, " %s", pipelines[k].name);
	fprintf(stderr, "\n");
	return false;
}

static bool read_setting(Options* options, char* text)
{
	char* equals = strchr(text, '=');
	if (!equals || equals == text || !equals[1])
	{
		fprintf(stderr, "scree %s: --set %s: must be NAME=VALUE\n", options->name, text);
		return false;
	}
	if (options->setting_count == MAX_SETTINGS)
	{
		fprintf(stderr, "scree %s: --set may be repeated %d times\n", options->name, MAX_SETTINGS);
		return false;
	}
	*equals = 0;
	options->settings[options->setting_count++] = (SceneSetting){text, equals + 1};
	return true;
}

static bool read_size(Options* options, const char* text)
{
	char extra;
	if (sscanf(text, "%5dx%5d%c", &options->width, &options->height, &extra) == 2 && options->width >= 64 &&
	    options->height >= 64 && options->width <= 16384 && options->height <= 16384)
		return true;
	fprintf(stderr, "scree %s: --size %s: must be WxH, each 64 to 16384\n", options->name, text);
	return false;
}

static bool ends_in(const Options* options, const char* name, const char* text, const char* ending)
{
	size_t length = strlen(text), end = strlen(ending);
	if (length > end && strcmp(text + length - end, ending) == 0)
		return true;
	fprintf(stderr, "scree %s: --%s %s: must end in %s\n", options->name, name, text, ending);
	return false;
}

static bool read_renderer(const char* text)
{
	if (strcmp(text, "gl") == 0 || strcmp(text, "cairo") == 0)
		return true;
	fprintf(stderr, "scree run: --renderer %s: must be cairo or gl\n", text);
	return false;
}

static bool read_option(Options* options, char letter, char* value)
{
	switch (letter)
	{
	case 'n':
		return read_int(options, "steps", value, 1, 1000000000, &options->steps);
	case 't':
		return read_int(options, "threads", value, 1, 64, &options->threads);
	case 'r':
		return read_int(options, "repeats", value, 1, 1000, &options->repeats);
	case 'l':
		return read_lanes(options, value);
	case 'P':
		return read_pipeline(options, value);
	case 's':
		return read_setting(options, value);
	case 'S':
		return read_size(options, value);
	case 'd':
		options->device = value;
		return true;
	case 'p':
		options->picture = value;
		return ends_in(options, "picture", value, ".png");
	case 'v':
		options->video = value;
		return true;
	case 'R':
		options->renderer = value;
		return read_renderer(value);
	case 'x':
		options->script = value;
		return true;
	case 'a':
		options->paint = value;
		return true;
	case 'L':
		options->layers = value;
		return true;
	case 'c':
		options->csv = value;
		return true;
	case 'm':
		return read_int(options, "limit", value, 1, 1000000000, &options->limit);
	case 'D':
		options->draw = value;
		return true;
	case 'k':
		options->known = value;
		return true;
	case 'u':
		options->allow_unequal_bits = true;
		return true;
	case 'w':
		options->whole = true;
		return true;
	case 'N':
		options->names = true;
		return true;
	case 'q':
		options->quick = true;
		return true;
	default: // 'h'
		print_command_help(stdout, options->command);
		exit(fflush(stdout) == 0 ? EXIT_GOOD : EXIT_FAILED);
	}
}

// Where one option leaves another without effect: true after printing so, when one of letters is given.
static bool idle(const Options* options, unsigned given, const char* letters, const char* because)
{
	for (int k = 0; k < OPTION_COUNT; ++k)
	{
		if (!(given >> k & 1) || !strchr(letters, table[k].letter))
			continue;
		fprintf(stderr, "scree %s: --%s has no effect: %s\n", options->name, table[k].name, because);
		return true;
	}
	return false;
}

static bool have_effect(const Options* options, unsigned given)
{
	bool figure = options->command == FIGURE,
	     other = figure || options->command == VALIDATE || options->command == VIEW;
	if (options->command == RUN && !options->picture && !options->video &&
	    idle(options, given, "SRaL", "there is no --picture or --video"))
		return false;
	if (!other && strncmp(options->device, "opencl", 6) == 0 && idle(options, given, "tl", "the device is not the CPU"))
		return false;
	if (options->pipeline == PIPELINE_PAPER && idle(options, given, "l", "the pipeline paper knows no lanes"))
		return false;
	if (options->pipeline == PIPELINE_PAPER && options->threads > 1 &&
	    idle(options, given, "t", "the pipeline paper runs on one thread"))
		return false;
	if (figure && options->draw && idle(options, given, "ndtlurm", "--draw measures nothing"))
		return false;
	if (options->command == VALIDATE && options->names && idle(options, given, "dtluq", "--names runs nothing"))
		return false;
	return !options->whole || !idle(options, given, "k", "--whole knows no hashes");
}

bool options_read(Options* options, int count, char** words)
{
	struct option longs[OPTION_COUNT + 1];
	char shorts[2 * OPTION_COUNT + 2] = ":";
	for (int k = 0; k < OPTION_COUNT; ++k)
	{
		int argument = table[k].value ? required_argument : no_argument;
		longs[k] = (struct option){table[k].name, argument, NULL, table[k].letter};
		snprintf(shorts + strlen(shorts), 3, "%c%s", table[k].letter, table[k].value ? ":" : "");
	}
	longs[OPTION_COUNT] = (struct option){0};

	const char* command = options->name;
	unsigned given = 0; // a bit each
	opterr = 0;
	for (;;)
	{
		int letter = getopt_long(count, words, shorts, longs, NULL);
		if (letter == -1)
			break;
		const char* word = words[optind - 1];
		if (letter == '?')
		{
			fprintf(stderr, "scree %s: unknown option %s; scree help lists them\n", command, word);
			return false;
		}
		if (letter == ':')
		{
			fprintf(stderr, "scree %s: %s needs a value\n", command, word);
			return false;
		}
		for (int k = 0; k < OPTION_COUNT; ++k)
		{
			if (table[k].letter != letter)
				continue;
			if (!(table[k].commands & options->command))
			{
				fprintf(stderr, "scree %s: takes no --%s\n", command, table[k].name);
				return false;
			}
			given |= 1u << k;
		}
		if (!read_option(options, (char)letter, optarg))
			return false;
	}
	options->arguments = words + optind;
	options->argument_count = count - optind;
	return have_effect(options, given);
}
