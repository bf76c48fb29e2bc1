// SPDX-License-Identifier: MIT
// command_options.c -- defines the options of scree, and the commands that accept each option.
#include "command_options.h"
#include "cli/common/option_values.h"
#include "platform/threads.h"
#include "tools/common/recording_file.h"
#include <stdio.h>
#include <string.h>

#define SCENE_WORLDS (RUN | HASH | BENCH | VIEW | FRAMES | QUERIES) // commands that create worlds of scenes
#define WORLDS       (SCENE_WORLDS | VALIDATE | REPLAY)             // commands that create worlds
#define ALL          (WORLDS | SCENES | DEVICES | DIFF)

static bool read_renderer(Options* options, const Option* option, char* text)
{
	options->renderer = text;
	if (strcmp(text, "gl") == 0 || strcmp(text, "cairo") == 0)
		return true;
	return refuse_value(options, option, text, "be cairo or gl");
}

static bool read_theme(Options* options, const Option* option, char* text)
{
	options->dark = strcmp(text, "dark") == 0;
	if (options->dark || strcmp(text, "light") == 0)
		return true;
	return refuse_value(options, option, text, "be light or dark");
}

static bool read_sleep(Options* options, const Option* option, char* text)
{
	options->sleep = strcmp(text, "on") == 0 ? SLEEP_ON : SLEEP_OFF;
	if (options->sleep == SLEEP_ON || strcmp(text, "off") == 0)
		return true;
	return refuse_value(options, option, text, "be on or off");
}

static bool read_hash_interval(Options* options, const Option* option, char* text)
{
	char extra;
	if (sscanf(text, "%9d%c", &options->hash_interval, &extra) == 1 && options->hash_interval >= 0)
		return true;
	return refuse_value(options, option, text, "be a whole number from 0 to 999999999");
}

static bool read_show(Options* options, const Option* option, char* text)
{
	char extra;
	if (sscanf(text, "%9d%c", &options->show, &extra) == 1 && options->show >= 0)
		return true;
	return refuse_value(options, option, text, "be a whole number from 0");
}

static bool read_resets(Options* options, const Option* option, char* text)
{
	char extra;
	if (sscanf(text, "%f%c", &options->resets, &extra) == 1 && options->resets > 0.0f && options->resets <= 100.0f)
		return true;
	return refuse_value(options, option, text, "be a number above 0, at most 100");
}

static bool read_part(Options* options, const Option* option, char* text)
{
	char extra;
	if (sscanf(text, "%5d/%5d%c", &options->part, &options->parts, &extra) == 2 && options->part > 0 &&
	    options->part <= options->parts)
		return true;
	return refuse_value(options, option, text, "be K/N, part K of N, from 1/N to N/N");
}

static bool read_scale(Options* options, const Option* option, char* text)
{
	char extra;
	if (sscanf(text, "%f%c", &options->scale, &extra) == 1 && options->scale >= 0.5f && options->scale <= 4.0f)
		return true;
	return refuse_value(options, option, text, "be a number from 0.5 to 4");
}

static const Option device = {"device", 'd', "NAME",
                              "auto, cpu, opencl, or opencl:NAME; NAME: part of the name of the device or of its "
                              "driver, case ignored; '#2' at its end: the second of equal devices",
                              TEXT(Options, device)};
static const Option sleep_option = {"sleep", 'e', "NAME",
                                    "on or off: whether bodies at rest fall asleep; default: that of the scene",
                                    OTHER(read_sleep)};
static const Option renderer = {"renderer", 'R', "NAME",
                                "renderer of pictures and video: cairo, or gl, which draws on a GPU; default cairo",
                                OTHER(read_renderer)};
static const Option paint = {"paint", 'a', "NAME", "paint of the bodies, in the viewer or with --renderer gl, one of"
#define X(enumerator, name, help) " " name
#include "view/paints.def"
#undef X
                             ,
                             TEXT(Options, paint)};
static const Option theme = {"theme", 'T', "NAME", "light or dark, in the viewer or with --renderer gl; default light",
                             OTHER(read_theme)};
static const Option scale = {
    "scale", 'z', "N", "scale of the panel and its letters, 0.5 to 4; default: that of the display", OTHER(read_scale)};
static const Option layers = {"layers", 'L', "NAME,...",
                              "layers over the bodies, in the viewer or with --renderer gl, any of"
#define X(name, key, shown, help) " " #name
#include "view/layers.def"
#undef X
                              ,
                              TEXT(Options, layers)};
static const Option script = {"script", 'x', "FILE", "file of user actions, one per line: docs/manual/view.md",
                              TEXT(Options, script)};
static const Option record = {"record", 'o', "FILE", "record all calls, for scree replay: docs/manual/recording.md",
                              TEXT(Options, record)};
static const Option hash_interval = {"hash-interval", 'i', "N",
                                     "steps from one hash of the recording to the next; 0: only the last; default 60",
                                     OTHER(read_hash_interval)};
static const Option recovery_interval = {
    "recovery-interval", 'I', "N",
    "steps between kept states, from one of which a run goes on on the CPU if the device fails: docs/manual/faults.md",
    NUMBER(Options, recovery_interval, 999999999)};
static const Option save = {"save", 'W', "FILE", "write a snapshot of the last state: docs/manual/snapshots.md",
                            TEXT(Options, save)};
static const Option load = {"load", 'O', "FILE", "begin with the state of a snapshot of the same scene",
                            TEXT(Options, load)};
static const Option write_scene = {"write-scene", 'X', "FILE",
                                   "write the last state as a scene file: docs/manual/scenes.md",
                                   TEXT(Options, write_scene)};
static const Option against = {"against", 'A', "NAME",
                               "device of a second world: the states of both are compared after each step",
                               TEXT(Options, against)};
static const Option queries = {"queries", 'Q', "N", "number of queries of each kind; default: a million",
                               NUMBER(Options, queries, 16000000)};
static const Option repeats = {"repeats", 'r', "N", "runs of each scene or kind of query; default 3",
                               NUMBER(Options, repeats, 1000)};
static const Option worlds = {
    "worlds", 'b', "N",
    "step N copies of a scene in one batch, on the CPU unless --device names another: docs/manual/batch.md",
    NUMBER(Options, worlds, 16777216)};
static const Option show = {"show", 'K', "N", "with --worlds: copy that results and files show; default 0",
                            OTHER(read_show)};
static const Option resets = {"resets", 'y', "PERCENT",
                              "with --worlds: part of the worlds that is reset before each step, at random",
                              OTHER(read_resets)};
static const Option template_steps = {"template-steps", 'f', "N",
                                      "with --worlds: steps of the scene before it is copied; default 0",
                                      NUMBER(Options, template_steps, 1000000)};
static const Option inputs = {"inputs", 'g', NULL,
                              "with --worlds: before each step, random speeds of motors or, without motors, forces",
                              SWITCH(Options, inputs)};
static const Option columns = {"columns", 'C', "N",
                               "with --worlds: after each step, at most N numbers of each world: poses and velocities",
                               NUMBER(Options, columns, 4096)};
static const Option part = {"part", 'P', "K/N",
                            "with --worlds: measure part K of N of the worlds; N processes measure them all",
                            OTHER(read_part)};
static const Option batches = {
    "batches", 'B', "N", "with --worlds: N batches share the worlds; a thread for each steps them at the same time",
    NUMBER(Options, batches, MAX_WORKERS)};
static const Option whole = {"whole", 'w', NULL,
                             "measure whole runs, including the time to open the device: docs/manual/auto.md",
                             SWITCH(Options, whole)};
static const Option names = {"names", 'N', NULL, "print only names, one per line", SWITCH(Options, names)};
static const Option test = {"test", 'E', NULL,
                            "test now whether the bits of each device are those of the CPU: docs/manual/devices.md",
                            SWITCH(Options, test)};
static const Option quick = {"quick", 'q', NULL, "fewer and shorter runs: seconds instead of minutes",
                             SWITCH(Options, quick)};

static const OptionRow rows[] = {
    {&option_steps, RUN | HASH | BENCH | FRAMES | QUERIES},
    {&device, WORLDS},
    {&option_threads, WORLDS},
    {&option_lanes, WORLDS},
    {&option_allow_unequal_bits, WORLDS},
    {&option_set, SCENE_WORLDS},
    {&sleep_option, SCENE_WORLDS},
    {&option_picture, RUN},
    {&option_video, RUN},
    {&option_size, RUN | FRAMES | VIEW},
    {&option_view, RUN},
    {&option_zoom, RUN},
    {&renderer, RUN},
    {&paint, RUN | VIEW},
    {&theme, RUN | VIEW},
    {&scale, VIEW},
    {&layers, RUN | VIEW},
    {&script, VIEW},
    {&option_csv, RUN},
    {&load, RUN | VIEW},
    {&save, RUN},
    {&write_scene, RUN},
    {&record, RUN | VIEW},
    {&hash_interval, RUN | VIEW},
    {&recovery_interval, RUN | BENCH},
    {&against, REPLAY},
    {&queries, QUERIES},
    {&repeats, BENCH | QUERIES},
    {&whole, BENCH},
    {&worlds, RUN | HASH | BENCH | VIEW},
    {&show, RUN},
    {&resets, BENCH},
    {&template_steps, BENCH},
    {&inputs, BENCH},
    {&columns, BENCH},
    {&part, BENCH},
    {&batches, BENCH},
    {&option_known, BENCH},
    {&names, SCENES | VALIDATE},
    {&test, DEVICES},
    {&quick, VALIDATE},
    {&option_help, ALL},
};
#define ROW_COUNT (int)(sizeof rows / sizeof rows[0])
_Static_assert(ROW_COUNT <= MAX_OPTIONS, "one bit of an uint64_t per option");

// Returns whether all files that a command writes have different paths, apart from devices such as /dev/null. If not, prints
// an error message.
static bool paths_differ(const Options* options)
{
	const struct
	{
		const Option* option;
		const char* path;
	} files[] = {
	    {&option_picture, options->picture}, {&option_video, options->video}, {&option_csv, options->csv},
	    {&record, options->record},          {&save, options->save},          {&write_scene, options->write_scene}};
	for (size_t k = 1; k < sizeof files / sizeof *files; ++k)
		for (size_t n = 0; files[k].path && strncmp(files[k].path, "/dev/", 5) != 0 && n < k; ++n)
			if (files[n].path && strcmp(files[n].path, files[k].path) == 0)
			{
				fprintf(stderr, "%s %s: --%s and --%s name the same file: %s\n", program_name, options->name,
				        files[n].option->name, files[k].option->name, files[k].path);
				return false;
			}
	return true;
}

static bool have_effect(const OptionTable* table, const Options* options, uint64_t given)
{
	bool other = options->command == VALIDATE || options->command == VIEW;
	if (options->command == RUN && !options->picture && !options->video &&
	    options_no_effect(table, options, given, "SRaLTVZ", "there is no --picture or --video"))
		return false;
	if (options->command == VIEW && options->argument_count > 0 && recording_file(options->arguments[0]) &&
	    options_no_effect(table, options, given, "seOb", "the world is that of a recording"))
		return false;
	if (!options->record && options_no_effect(table, options, given, "i", "there is no --record"))
		return false;
	if (!other && strncmp(options->device, "opencl", 6) == 0 &&
	    options_no_effect(table, options, given, "tl", "the device is not the CPU"))
		return false;
	if (strcmp(options->device, "cpu") == 0 && options_no_effect(table, options, given, "I", "the device is the CPU"))
		return false;
	if (options->command == VALIDATE && options->names &&
	    options_no_effect(table, options, given, "dtluq", "--names runs nothing"))
		return false;
	if (options->worlds == 0 && options_no_effect(table, options, given, "yfKgCPB", "there is no --worlds"))
		return false;
	if (options->worlds > 0 && options_no_effect(table, options, given, "wI", "--worlds steps a batch"))
		return false;
	if (options->worlds > 0 &&
	    options_no_effect(table, options, given, "vco", "--worlds shows only the last state of a world"))
		return false;
	if (options->command == VIEW && options->worlds > 0 &&
	    options_no_effect(table, options, given, "LoO", "--worlds shows a wall of worlds"))
		return false;
	if (options->worlds > 0 && options->show >= options->worlds)
	{
		fprintf(stderr, "%s %s: --show %d: must be from 0 to %d, because --worlds is %d\n", program_name, options->name,
		        options->show, options->worlds - 1, options->worlds);
		return false;
	}
	if (options->worlds > 0 && options->parts > options->worlds)
	{
		fprintf(stderr, "%s %s: --part %d/%d: there are %d worlds\n", program_name, options->name, options->part,
		        options->parts, options->worlds);
		return false;
	}
	if (options->worlds > 0 && options->batches > options->worlds / options->parts)
	{
		fprintf(stderr, "%s %s: --batches %d: there are %d worlds\n", program_name, options->name, options->batches,
		        options->worlds / options->parts);
		return false;
	}
	if (options->whole && options_no_effect(table, options, given, "k", "--whole compares no hashes"))
		return false;
	return paths_differ(options);
}

const OptionTable command_options = {rows, ROW_COUNT, have_effect};
