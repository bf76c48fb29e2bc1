// SPDX-License-Identifier: MIT
// command_line.h -- reads the command line of a program: runs the command that its first words name, or prints help.
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H
#include "options.h"

typedef struct
{
	int bit;          // bit in OptionRow.commands
	const char* name; // one word, or two, such as "bench frames"; bench may also be a command
	const char *usage, *help;
	int least, most;                    // minimum and maximum number of arguments
	int (*run)(const Options* options); // returns an exit code
	void (*print_more)(FILE* file);     // prints more help after the options; may be null
} Command;

typedef struct
{
	const char *name, *title;
	const Command* commands;
	int command_count;
	OptionTable options;
} CommandLine;

// Runs the command that the words name. *options: holds the default values, and gets the values of the words. It is an
// Options, or a larger struct that begins with Options. Returns the exit code.
int command_line_run(const CommandLine* line, Options* options, int count, char** words);

#endif
