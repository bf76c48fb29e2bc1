// SPDX-License-Identifier: MIT
// log_lines.c -- stores the messages of the library for tests, instead of printing them.
#include "support/log_lines.h"
#include <stdio.h>
#include <string.h>

#define LINES 4

int log_count, warning_count;
char last_warning[512];
static char lines[LINES][512];

static void keep_line(scree_log_level level, const char* sentence, void* context)
{
	(void)context;
	snprintf(lines[log_count++ % LINES], sizeof lines[0], "%s", sentence);
	if (level != SCREE_LOG_WARNING)
		return;
	++warning_count;
	snprintf(last_warning, sizeof last_warning, "%s", sentence);
}

int keep_log(void** state)
{
	(void)state;
	const scree_hooks hooks = {.log = keep_line};
	memset(lines, 0, sizeof lines);
	last_warning[0] = '\0';
	log_count = warning_count = 0;
	return scree_hooks_set(&hooks);
}

int release_log(void** state)
{
	(void)state;
	return scree_hooks_set(NULL);
}

bool was_logged(const char* words)
{
	for (int k = 0; k < LINES; ++k)
		if (strstr(lines[k], words))
			return true;
	return false;
}
