// SPDX-License-Identifier: MIT
// paper_options.h -- declares the options of scree_paper, and the commands that accept them.
#ifndef PAPER_OPTIONS_H
#define PAPER_OPTIONS_H
#include "cli/common/options.h"

enum // commands as bits, because several commands may accept an option
{
	RUN = 1,
	HASH = 2,
	BENCH = 4,
	FIGURE = 8, // figure5 and figure6
};

typedef struct
{
	Options common;   // options of all commands; a null device means the CPU, or all devices in figures
	int limit;        // maximum number of bodies in a figure; 0: unlimited
	const char* draw; // path of the CSV to draw; null: the figure is measured
} PaperOptions;

extern const OptionTable paper_options;

#endif
