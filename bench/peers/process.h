// SPDX-License-Identifier: MIT
// process.h -- runs this program again in a new process.
#ifndef PROCESS_H
#define PROCESS_H
#include <stdbool.h>
#include <stddef.h>

// Runs words[0] with words (ended by null) and waits for it. Its first line of output goes to line. Returns its exit code,
// -1 when it could not be run or was killed.
int process_run(char* const* words, char* line, size_t size);

#endif
