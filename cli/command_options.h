// SPDX-License-Identifier: MIT
// command_options.h -- the options of scree, and the commands that take them.
#ifndef COMMAND_OPTIONS_H
#define COMMAND_OPTIONS_H
#include "cli/common/options.h"

enum // bits, so that an option can belong to several commands
{
	RUN = 1,
	HASH = 2,
	SCENES = 4,
	DEVICES = 8,
	BENCH = 16,
	VIEW = 32,
	FRAMES = 64, // bench frames
	VALIDATE = 128,
	QUERIES = 256, // bench queries
};

extern const OptionTable command_options;

#endif
