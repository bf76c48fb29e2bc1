// SPDX-License-Identifier: MIT
// process.h -- exit codes, and a run of this program in a new process.
#ifndef PROCESS_H
#define PROCESS_H
#include <stdbool.h>
#include <stddef.h>

// exit codes, as those of the command line
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // an engine or memory failed
#define EXIT_BAD    2 // a bad command line or scene

// Runs words[0] with words (ended by null) and waits for it. Its first line of output goes to line. Returns its exit code,
// -1 when it could not be run or was killed.
int process_run(char* const* words, char* line, size_t size);

#endif
