// SPDX-License-Identifier: MIT
// help.h -- prints the commands and options.
#ifndef HELP_H
#define HELP_H
#include "options.h"

// Prints the table of commands.
void print_help(FILE* file);

// Prints the options of a command; for view also the keys, for validate also the experiments.
void print_command_help(FILE* file, Command command);

#endif
