// SPDX-License-Identifier: MIT
// main.c -- scree_paper: the command line for the pipeline of the paper that Scree started from, and for two figures of
// that paper.
#include "cli/common/command_line.h"
#include "tools/paper/paper_commands.h"
#include "tools/paper/paper_options.h"

static const Command commands[] = {
    {RUN, "run", "run SCENE|FILE", "simulate, with a table of results at the end", 1, 1, paper_run_command, NULL},
    {HASH, "hash", "hash SCENE|FILE", "simulate and print the hash of bodies and contacts, 16 digits, alone", 1, 1,
     paper_hash_command, NULL},
    {BENCH, "bench", "bench SCENE|FILE...", "measure scenes, CSV on standard output", 1, 1000, paper_bench_command,
     NULL},
    {FIGURE, "figure5", "figure5", "measure and draw time by number of bodies; Scree too (docs/measurements/paper.md)",
     0, 0, figure5_command, NULL},
    {FIGURE, "figure6", "figure6", "measure and draw the share of the stages; Scree too (docs/measurements/paper.md)",
     0, 0, figure6_command, NULL},
};

int main(int count, char** words)
{
	const CommandLine line = {"scree_paper",
	                          "the pipeline of the paper that Scree started from, and the paper's figures", commands,
	                          (int)(sizeof commands / sizeof commands[0]), paper_options};
	PaperOptions options = {.common = {.width = 1600, .height = 900, .repeats = 3}};
	return command_line_run(&line, &options.common, count, words);
}
