// SPDX-License-Identifier: MIT
// process.h -- defines exit codes, and runs a program in a new process.
#ifndef PROCESS_H
#define PROCESS_H
#include <stdbool.h>
#include <stddef.h>

// exit codes, the same as those of the command line scree
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // an engine or memory failed
#define EXIT_BAD    2 // a bad command line or scene

// Runs the program words[0] with the arguments words, whose list ends with null, until the program ends. line: receives
// the first line of its output. Returns its exit code, or -1 if it could not be run or was killed.
int process_run(char* const* words, char* line, size_t size);

#endif
