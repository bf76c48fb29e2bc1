// SPDX-License-Identifier: MIT
// command_line.h -- the command line of a program: runs the command that its first words name, and prints help.
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H
#include "options.h"

typedef struct
{
	int bit;          // bit in OptionRow.commands
	const char* name; // one word, or two, such as "bench frames"; the first of two words may also be a command
	const char *usage, *help;
	int least, most;                    // range of the number of arguments
	int (*run)(const Options* options); // returns an exit code
	void (*print_more)(FILE* file);     // prints more help after the options; null: there is none
} Command;

typedef struct
{
	const char *name, *title;
	const Command* commands;
	int command_count;
	OptionTable options;
} CommandLine;

// Runs a command. options contains the defaults, and has the type that the rows of the table set. Returns the exit
// code.
int command_line_run(const CommandLine* line, Options* options, int count, char** words);

#endif
