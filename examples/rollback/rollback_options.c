// SPDX-License-Identifier: MIT
// rollback_options.c -- reads the command line with a table of options.
#include "rollback_options.h"
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum
{
	SWITCH,
	NUMBER,
	NUMBERS, // one for both peers, or two with a comma
	NAMES,   // the same with names
	TEXT,
} ValueKind;

typedef struct
{
	const char* name;
	ValueKind kind;
	size_t offset;
	int least, most; // range of numbers
	const char *initial, *help;
} OptionLine;

static const OptionLine lines[] = {
#define X(name, kind, member, least, most, initial, help) \
	{name, kind, offsetof(RollbackOptions, member), least, most, initial, help},
#include "rollback_options.def"
#undef X
};
#define LINES ((int)(sizeof lines / sizeof *lines))

static bool refuse(const OptionLine* line, const char* text)
{
	if (line->kind == NAMES)
		fprintf(stderr, "rollback: --%s %s: must be one or two names of at most 95 letters\n", line->name, text);
	else
		fprintf(stderr, "rollback: --%s %s: must be %s from %d to %d\n", line->name, text,
		        line->kind == NUMBERS ? "one or two whole numbers" : "a whole number", line->least, line->most);
	return false;
}

// Reads a value, which ends at a comma or at the end of the text.
static bool read_one(const OptionLine* line, const char* text, size_t length, RollbackOptions* options, int peer)
{
	char* member = (char*)options + line->offset;
	if (line->kind == NAMES)
	{
		if (length == 0 || length >= sizeof options->device[0])
			return false;
		memcpy(member + sizeof options->device[0] * (size_t)peer, text, length);
		member[sizeof options->device[0] * (size_t)peer + length] = 0;
		return true;
	}
	char* end;
	long value = strtol(text, &end, 10);
	if (*text < '0' || *text > '9' || end != text + length || value < line->least || value > line->most)
		return false;
	((int*)(void*)member)[peer] = (int)value;
	return true;
}

static bool read_value(RollbackOptions* options, const OptionLine* line, const char* text)
{
	char* member = (char*)options + line->offset;
	if (line->kind == SWITCH)
		*(bool*)member = true;
	else if (line->kind == TEXT)
		*(const char**)(void*)member = text;
	else if (line->kind == NUMBER)
		return read_one(line, text, strlen(text), options, 0) || refuse(line, text);
	else
	{
		const char* comma = strchr(text, ',');
		const char* second = comma ? comma + 1 : text;
		size_t length = comma ? (size_t)(comma - text) : strlen(text);
		return (read_one(line, text, length, options, 0) && read_one(line, second, strlen(second), options, 1)) ||
		       refuse(line, text);
	}
	return true;
}

bool options_parse(RollbackOptions* options, int count, char** words)
{
	*options = (RollbackOptions){0};
	for (int k = 0; k < LINES; ++k)
		if (lines[k].initial)
			read_value(options, &lines[k], lines[k].initial);
	for (int k = 0; k < count; ++k)
	{
		const OptionLine* line = NULL;
		for (int j = 0; j < LINES && !line; ++j)
			if (strncmp(words[k], "--", 2) == 0 && strcmp(words[k] + 2, lines[j].name) == 0)
				line = &lines[j];
		if (!line)
		{
			fprintf(stderr, "rollback: unknown option %s; --help lists all\n", words[k]);
			return false;
		}
		if (line->kind != SWITCH && ++k == count)
		{
			fprintf(stderr, "rollback: --%s needs a value\n", line->name);
			return false;
		}
		if (!read_value(options, line, words[k]))
			return false;
	}
	for (int k = 0; k < 2; ++k)
		if (options->prediction[k] == 0 && options->input_delay[k] == 0)
		{
			fprintf(stderr, "rollback: --prediction 0 needs an --input-delay of 1 or more\n");
			return false;
		}
	return true;
}

void options_print(void)
{
	puts("rollback -- two players, each on a machine or a device of their own, by UDP with prediction and rollback.\n"
	     "\n"
	     "  rollback --demo --device cpu,opencl --delay 60 --jitter 30 --loss 10 --reorder 10\n"
	     "  rollback --peer 0 & rollback --peer 1 --device opencl\n"
	     "\n"
	     "Two values with a comma are those of peer 0 and peer 1.\n");
	for (int k = 0; k < LINES; ++k)
	{
		static const char* const values[] = {"", "N", "N[,N]", "NAME[,NAME]", "TEXT"};
		char left[40];
		snprintf(left, sizeof left, "--%s %s", lines[k].name, values[lines[k].kind]);
		printf("  %-26s%s", left, lines[k].help);
		if (lines[k].initial)
			printf(" (%s)", lines[k].initial);
		printf("\n");
	}
}
