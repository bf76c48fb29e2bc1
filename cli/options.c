// SPDX-License-Identifier: MIT
// options.c -- reads the command line with a table of options.
#include "options.h"
#include <ctype.h>
#include <getopt.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define WORLDS (RUN | HASH | BENCH | VIEW | FRAMES | FIGURE | VALIDATE | QUERIES) // commands that make worlds
#define ALL    (WORLDS | SCENES | DEVICES)

static const struct
{
	const char* name;
	PipelineChoice choice;
} pipelines[] = {{"soft", PIPELINE_SOFT}, {"paper", PIPELINE_PAPER}};
#define PIPELINE_COUNT (int)(sizeof pipelines / sizeof pipelines[0])

static bool read_switch(Options* options, const OptionRow* row, char* text)
{
	(void)text;
	*(bool*)((char*)options + row->offset) = true;
	return true;
}

static bool read_text(Options* options, const OptionRow* row, char* text)
{
	*(const char**)((char*)options + row->offset) = text;
	return true;
}

static bool read_number(Options* options, const OptionRow* row, char* text)
{
	char* end;
	long value = strtol(text, &end, 10);
	if (isdigit((unsigned char)*text) && !*end && value >= 1 && value <= row->most)
	{
		*(int*)((char*)options + row->offset) = (int)value;
		return true;
	}
	fprintf(stderr, "scree %s: --%s %s: must be a whole number from 1 to %d\n", options->name, row->name, text,
	        row->most);
	return false;
}

static bool read_lanes(Options* options, const OptionRow* row, char* text)
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
	fprintf(stderr, "scree %s: --%s %s: must be 1, 4, 8 or 16\n", options->name, row->name, text);
	return false;
}

static bool read_pipeline(Options* options, const OptionRow* row, char* text)
{
	for (int k = 0; k < PIPELINE_COUNT; ++k)
	{
		if (strcmp(text, pipelines[k].name) == 0)
		{
			options->pipeline = pipelines[k].choice;
			return true;
		}
	}
	fprintf(stderr, "scree %s: --%s %s: must be one of", options->name, row->name, text);
	for (int k = 0; k < PIPELINE_COUNT; ++k)
		fprintf(stderr, " %s", pipelines[k].name);
	fprintf(stderr, "\n");
	return false;
}

static bool read_setting(Options* options, const OptionRow* row, char* text)
{
	char* equals = strchr(text, '=');
	if (!equals || equals == text || !equals[1])
	{
		fprintf(stderr, "scree %s: --%s %s: must be NAME=VALUE\n", options->name, row->name, text);
		return false;
	}
	if (options->setting_count == MAX_SETTINGS)
	{
		fprintf(stderr, "scree %s: --%s may be repeated %d times\n", options->name, row->name, MAX_SETTINGS);
		return false;
	}
	*equals = 0;
	options->settings[options->setting_count++] = (SceneSetting){text, equals + 1};
	return true;
}

static bool read_size(Options* options, const OptionRow* row, char* text)
{
	char extra;
	if (sscanf(text, "%5dx%5d%c", &options->width, &options->height, &extra) == 2 && options->width >= 64 &&
	    options->height >= 64 && options->width <= 16384 && options->height <= 16384)
		return true;
	fprintf(stderr, "scree %s: --%s %s: must be WxH, each 64 to 16384\n", options->name, row->name, text);
	return false;
}

static bool read_box(const Options* options, const OptionRow* row, const char* text, bool* there, scree_box* box)
{
	char extra;
	scree_vec *low = &box->lower, *high = &box->upper;
	*there = sscanf(text, "%f,%f,%f,%f%c", &low->x, &low->y, &high->x, &high->y, &extra) == 4 && low->x < high->x &&
	         low->y < high->y && low->x >= -SCREE_MAX_COORDINATE && low->y >= -SCREE_MAX_COORDINATE &&
	         high->x <= SCREE_MAX_COORDINATE && high->y <= SCREE_MAX_COORDINATE;
	if (!*there)
		fprintf(stderr,
		        "scree %s: --%s %s: must be LEFT,BOTTOM,RIGHT,TOP in metres, LEFT below RIGHT, BOTTOM below TOP\n",
		        options->name, row->name, text);
	return *there;
}

static bool read_view(Options* options, const OptionRow* row, char* text)
{
	return read_box(options, row, text, &options->has_view, &options->view);
}

static bool read_zoom(Options* options, const OptionRow* row, char* text)
{
	return read_box(options, row, text, &options->has_zoom, &options->zoom);
}

static bool read_picture(Options* options, const OptionRow* row, char* text)
{
	size_t length = strlen(text);
	options->picture = text;
	if (length > 4 && strcmp(text + length - 4, ".png") == 0)
		return true;
	fprintf(stderr, "scree %s: --%s %s: must end in .png\n", options->name, row->name, text);
	return false;
}

static bool read_renderer(Options* options, const OptionRow* row, char* text)
{
	options->renderer = text;
	if (strcmp(text, "gl") == 0 || strcmp(text, "cairo") == 0)
		return true;
	fprintf(stderr, "scree %s: --%s %s: must be cairo or gl\n", options->name, row->name, text);
	return false;
}

static bool read_theme(Options* options, const OptionRow* row, char* text)
{
	options->dark = strcmp(text, "dark") == 0;
	if (options->dark || strcmp(text, "light") == 0)
		return true;
	fprintf(stderr, "scree %s: --%s %s: must be light or dark\n", options->name, row->name, text);
	return false;
}

static bool read_scale(Options* options, const OptionRow* row, char* text)
{
	char extra;
	if (sscanf(text, "%f%c", &options->scale, &extra) == 1 && options->scale >= 0.5f && options->scale <= 4.0f)
		return true;
	fprintf(stderr, "scree %s: --%s %s: must be a number from 0.5 to 4\n", options->name, row->name, text);
	return false;
}

// how an option is read, and the member that it sets
#define SWITCH(member)       read_switch, offsetof(Options, member), 0
#define TEXT(member)         read_text, offsetof(Options, member), 0
#define NUMBER(member, most) read_number, offsetof(Options, member), most
#define OTHER(read)          read, 0, 0

const OptionRow option_rows[] = {
    {"steps", 'n', "N", RUN | HASH | BENCH | FRAMES | FIGURE | QUERIES,
     "steps to take; without it as many as the scene says", NUMBER(steps, 1000000000)},
    {"device", 'd', "NAME", WORLDS, "auto, cpu, opencl, or opencl:NAME with part of a device's name", TEXT(device)},
    {"threads", 't', "N", WORLDS, "CPU threads, 1 to 64; without it one a core", NUMBER(threads, 64)},
    {"lanes", 'l', "N", WORLDS, "CPU SIMD lanes: 1, 4, 8 or 16; without it the widest there is", OTHER(read_lanes)},
    {"pipeline", 'P', "NAME", RUN | HASH | BENCH, "soft: the soft step solver; paper: the paper's, on one thread",
     OTHER(read_pipeline)},
    {"allow-unequal-bits", 'u', NULL, WORLDS, "use a device that cannot keep the promise of equal bits",
     SWITCH(allow_unequal_bits)},
    {"set", 's', "NAME=VALUE", WORLDS & ~(FIGURE | VALIDATE),
     "give a parameter of the scene another value; may be repeated", OTHER(read_setting)},
    {"picture", 'p', "FILE.png", RUN, "draw the end state", OTHER(read_picture)},
    {"video", 'v', "FILE.mp4", RUN, "60 frames a second of the world's time, through ffmpeg", TEXT(video)},
    {"size", 'S', "WxH", RUN | FRAMES | VIEW, "pixels of picture, video, frames and window, 1600x900 without it",
     OTHER(read_size)},
    {"view", 'V', "L,B,R,T", RUN,
     "what picture and video show: left, bottom, right, top in metres; as the scene says without it", OTHER(read_view)},
    {"zoom", 'Z', "L,B,R,T", RUN, "during the run the view moves to this one", OTHER(read_zoom)},
    {"renderer", 'R', "NAME", RUN, "of pictures and video: cairo, or gl, which draws on a GPU; cairo without it",
     OTHER(read_renderer)},
    {"paint", 'a', "NAME", RUN | VIEW,
     "with gl: color bodies by attribute, speed, graph (colors of the solver), force, start or type", TEXT(paint)},
    {"theme", 'T', "NAME", RUN | VIEW, "with gl: light or dark; light without it", OTHER(read_theme)},
    {"scale", 'z', "N", VIEW, "size of the panel and its letters, 0.5 to 4; without it as the display says",
     OTHER(read_scale)},
    {"layers", 'L', "NAME,...", RUN | VIEW,
     "with gl: boxes, contacts, normals, impulses, velocities, sensors, rays, visits, touches, hits, breaks, joints, "
     "centers, fields",
     TEXT(layers)},
    {"script", 'x', "FILE", VIEW, "a file of user actions, one a line: docs/view.md", TEXT(script)},
    {"csv", 'c', "FILE.csv", RUN, "one row a step: counters and milliseconds", TEXT(csv)},
    {"queries", 'Q', "N", QUERIES, "of each kind, a million without it", NUMBER(queries, 16000000)},
    {"repeats", 'r', "N", BENCH | FIGURE | QUERIES, "runs of each scene or kind of query, 3 without it",
     NUMBER(repeats, 1000)},
    {"whole", 'w', NULL, BENCH, "time whole runs, the opening of the device included; see docs/auto.md", SWITCH(whole)},
    {"known", 'k', "FILE.csv", BENCH, "rows of an earlier bench; the hashes must be the same", TEXT(known)},
    {"limit", 'm', "N", FIGURE, "most bodies, a million without it", NUMBER(limit, 1000000000)},
    {"draw", 'D', "FILE.csv", FIGURE, "draw what an earlier bench measured", TEXT(draw)},
    {"names", 'N', NULL, SCENES | VALIDATE, "names alone, one a line", SWITCH(names)},
    {"quick", 'q', NULL, VALIDATE, "fewer and shorter runs: seconds, not minutes", SWITCH(quick)},
    {"help", 'h', NULL, ALL, "this text", SWITCH(help)},
};
#define OPTION_COUNT (int)(sizeof option_rows / sizeof option_rows[0])
const int option_count = OPTION_COUNT;
_Static_assert(OPTION_COUNT <= 32, "a bit of an unsigned for each option that was given");

// Whether an option of letters was given; if so, prints why it has no effect.
static bool no_effect(const Options* options, unsigned given, const char* letters, const char* because)
{
	for (int k = 0; k < OPTION_COUNT; ++k)
	{
		if (!(given >> k & 1) || !strchr(letters, option_rows[k].letter))
			continue;
		fprintf(stderr, "scree %s: --%s has no effect: %s\n", options->name, option_rows[k].name, because);
		return true;
	}
	return false;
}

static bool have_effect(const Options* options, unsigned given)
{
	bool figure = options->command == FIGURE,
	     other = figure || options->command == VALIDATE || options->command == VIEW;
	if (options->command == RUN && !options->picture && !options->video &&
	    no_effect(options, given, "SRaLTVZ", "there is no --picture or --video"))
		return false;
	if (!other && strncmp(options->device, "opencl", 6) == 0 &&
	    no_effect(options, given, "tl", "the device is not the CPU"))
		return false;
	if (options->pipeline == PIPELINE_PAPER && no_effect(options, given, "l", "the pipeline paper has no lanes"))
		return false;
	if (options->pipeline == PIPELINE_PAPER && options->threads > 1 &&
	    no_effect(options, given, "t", "the pipeline paper runs on one thread"))
		return false;
	if (figure && options->draw && no_effect(options, given, "ndtlurm", "--draw measures nothing"))
		return false;
	if (options->command == VALIDATE && options->names && no_effect(options, given, "dtluq", "--names runs nothing"))
		return false;
	return !options->whole || !no_effect(options, given, "k", "--whole compares no hashes");
}

// Finds the row of an option. Returns null after printing that the command does not take the option.
static const OptionRow* find_row(const Options* options, int letter)
{
	const OptionRow* row = option_rows;
	while (row->letter != letter)
		++row;
	if (row->commands & options->command)
		return row;
	fprintf(stderr, "scree %s: takes no --%s\n", options->name, row->name);
	return NULL;
}

// Reads the options; given gets a bit for each row. Stops at --help.
static bool read_all(Options* options, int count, char** words, const char* shorts, const struct option* longs,
                     unsigned* given)
{
	opterr = 0;
	for (int letter; !options->help && (letter = getopt_long(count, words, shorts, longs, NULL)) != -1;)
	{
		const char* word = words[optind - 1];
		if (letter == '?')
		{
			fprintf(stderr, "scree %s: unknown option %s; scree help lists them\n", options->name, word);
			return false;
		}
		if (letter == ':')
		{
			fprintf(stderr, "scree %s: %s needs a value\n", options->name, word);
			return false;
		}
		const OptionRow* row = find_row(options, letter);
		if (!row || !row->read(options, row, optarg))
			return false;
		*given |= 1u << (row - option_rows);
	}
	return true;
}

bool options_read(Options* options, int count, char** words)
{
	struct option longs[OPTION_COUNT + 1];
	char shorts[2 * OPTION_COUNT + 2] = ":";
	for (int k = 0; k < OPTION_COUNT; ++k)
	{
		const OptionRow* row = &option_rows[k];
		longs[k] = (struct option){row->name, row->value ? required_argument : no_argument, NULL, row->letter};
		snprintf(shorts + strlen(shorts), 3, "%c%s", row->letter, row->value ? ":" : "");
	}
	longs[OPTION_COUNT] = (struct option){0};

	unsigned given = 0;
	if (!read_all(options, count, words, shorts, longs, &given))
		return false;
	options->arguments = words + optind;
	options->argument_count = count - optind;
	return options->help || have_effect(options, given);
}
