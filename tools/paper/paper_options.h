// SPDX-License-Identifier: MIT
// paper_options.h -- the options of scree_paper, and the commands that take them.
#ifndef PAPER_OPTIONS_H
#define PAPER_OPTIONS_H
#include "cli/common/options.h"

enum // bits, so that an option can belong to several commands
{
	RUN = 1,
	HASH = 2,
	BENCH = 4,
	FIGURE = 8, // figure5, figure6
};

typedef struct
{
	Options common;   // device: null for the CPU; in figures for all devices
	int limit;        // most bodies in a figure; 0: no limit
	const char* draw; // CSV of a figure; null: measure
} PaperOptions;

extern const OptionTable paper_options;

#endif
