// SPDX-License-Identifier: MIT
// paper_options.c -- defines the options of scree_paper, and the commands that accept them.
#include "tools/paper/paper_options.h"
#include "cli/common/option_values.h"

#define ALL (RUN | HASH | BENCH | FIGURE)

static const Option device = {
    "device", 'd', "NAME",
    "cpu, opencl, or opencl:NAME; NAME: part of the name of the device or of its driver, case ignored; cpu "
    "without it, but all devices for figures",
    TEXT(Options, device)};
static const Option repeats = {"repeats", 'r', "N", "runs of each scene or row, 3 without it",
                               NUMBER(Options, repeats, 1000)};
static const Option limit = {"limit", 'm', "N", "maximum number of bodies, a million without it",
                             NUMBER(PaperOptions, limit, 1000000000)};
static const Option draw = {"draw", 'D', "FILE.csv", "draw this measurement, without a new one",
                            TEXT(PaperOptions, draw)};

static const OptionRow rows[] = {
    {&option_steps, ALL},
    {&device, ALL},
    {&option_threads, FIGURE},
    {&option_lanes, FIGURE},
    {&option_allow_unequal_bits, ALL},
    {&option_set, ALL & ~FIGURE},
    {&option_picture, RUN},
    {&option_video, RUN},
    {&option_size, RUN},
    {&option_view, RUN},
    {&option_zoom, RUN},
    {&option_csv, RUN},
    {&repeats, BENCH | FIGURE},
    {&option_known, BENCH},
    {&limit, FIGURE},
    {&draw, FIGURE},
    {&option_help, ALL},
};
#define ROW_COUNT (int)(sizeof rows / sizeof rows[0])
_Static_assert(ROW_COUNT <= MAX_OPTIONS, "a bit of an uint64_t for each option that was given");

static bool have_effect(const OptionTable* table, const Options* options, uint64_t given)
{
	const PaperOptions* own = (const PaperOptions*)options;
	if (options->command == RUN && !options->picture && !options->video &&
	    options_no_effect(table, options, given, "SVZ", "there is no --picture or --video"))
		return false;
	return !own->draw || !options_no_effect(table, options, given, "ndtlurm", "--draw measures nothing");
}

const OptionTable paper_options = {rows, ROW_COUNT, have_effect};
