// SPDX-License-Identifier: MIT
// log_lines.h -- stores the messages of the library for tests, instead of printing them.
#ifndef LOG_LINES_H
#define LOG_LINES_H
#include "support/checks.h"

// Set-up, which begins to store messages, and tear-down, which ends it.
int keep_log(void** state);
int release_log(void** state);

extern int log_count, warning_count; // number of stored messages, warnings included; number of warnings
extern char last_warning[512];

// Returns whether one of the last four messages contains a text.
bool was_logged(const char* words);

#endif
