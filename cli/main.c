// SPDX-License-Identifier: MIT
// main.c -- the command line of Scree: selects the command.
#include "cli/common/command_line.h"
#include "command_options.h"
#include "commands.h"
#include "validate/validate.h"
#ifdef SCREE_HAVE_WINDOW
#include "view/window/run_viewer.h"
#endif

// Prints the keys of the window; prints nothing in a build without the viewer.
static void print_view_keys(FILE* file)
{
#ifdef SCREE_HAVE_WINDOW
	fprintf(file, "\nkeys of scree view\n");
	view_print_keys(file);
#else
	(void)file;
#endif
}

static void print_experiments(FILE* file)
{
	fprintf(file, "\nexperiments of scree validate\n");
	for (int k = 0; k < validate_count; ++k)
		fprintf(file, "  %-10s %s\n", validate_experiments[k].name, validate_experiments[k].shows);
}

static const Command commands[] = {
    {RUN, "run", "run SCENE|FILE", "simulate, with a table of results at the end", 1, 1, run_command, NULL},
    {VIEW, "view", "view [SCENE|FILE]", "open a window with a scene or a recording; default: pile", 0, 1, view_command,
     print_view_keys},
    {HASH, "hash", "hash SCENE|FILE", "simulate and print only the world's hash, 16 digits", 1, 1, hash_command, NULL},
    {REPLAY, "replay", "replay FILE", "repeat a recording and compare its hashes: docs/manual/recording.md", 1, 1,
     replay_command, NULL},
    {DIFF, "diff", "diff FILE FILE", "list the columns in which two snapshots differ: docs/manual/snapshots.md", 2, 2,
     diff_command, NULL},
    {SCENES, "scenes", "scenes", "list the scenes with their parameters", 0, 0, scenes_command, NULL},
    {DEVICES, "devices", "devices", "list the devices, and whether their results have equal bits", 0, 0,
     devices_command, NULL},
    {BENCH, "bench", "bench [SCENE|FILE]...", "measure scenes, default: all; CSV on standard output", 0, 1000,
     bench_command, NULL},
    {FRAMES, "bench frames", "bench frames SCENE|FILE", "measure steps with drawing: docs/measurements/drawing.md", 1,
     1, frames_command, NULL},
    {QUERIES, "bench queries", "bench queries SCENE|FILE",
     "measure rays and other queries at the end of a run: docs/measurements/queries.md", 1, 1, queries_command, NULL},
    {VALIDATE, "validate", "validate [NAME]...", "run the validation experiments: docs/measurements/validate.md", 0,
     1000, validate_command, print_experiments},
};

int main(int count, char** words)
{
	const CommandLine line = {"scree", "2D rigid body physics, bit-identical on every device", commands,
	                          (int)(sizeof commands / sizeof commands[0]), command_options};
	Options options = {.device = "auto",
	                   .width = 1600,
	                   .height = 900,
	                   .repeats = 3,
	                   .hash_interval = 60,
	                   .part = 1,
	                   .parts = 1,
	                   .batches = 1};
	return command_line_run(&line, &options, count, words);
}
