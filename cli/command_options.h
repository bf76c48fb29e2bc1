// SPDX-License-Identifier: MIT
// command_options.h -- defines the options of scree, and the commands that accept each option.
#ifndef COMMAND_OPTIONS_H
#define COMMAND_OPTIONS_H
#include "cli/common/options.h"

enum // commands; bits, so that an option can belong to several of them
{
	RUN = 1,
	HASH = 2,
	SCENES = 4,
	DEVICES = 8,
	BENCH = 16,
	VIEW = 32,
	FRAMES = 64, // the command bench frames
	VALIDATE = 128,
	QUERIES = 256, // the command bench queries
	REPLAY = 512,
	DIFF = 1024,
};

extern const OptionTable command_options;

#endif
