// SPDX-License-Identifier: MIT
// log_lines.h -- the log of the library, stored for tests instead of printed.
#ifndef LOG_LINES_H
#define LOG_LINES_H
#include "support/checks.h"

// Set-up and tear-down.
int keep_log(void** state);
int release_log(void** state);

extern int log_count, warning_count; // numbers of messages, and of warnings among them
extern char last_warning[512];

// Returns whether one of the last four messages contains these words.
bool was_logged(const char* words);

#endif
