// SPDX-License-Identifier: MIT
// options.c -- reads the options of a command with a table.
#include "options.h"
#include <getopt.h>
#include <string.h>

const char* program_name = "scree";

bool options_no_effect(const OptionTable* table, const Options* options, uint64_t given, const char* letters,
                       const char* because)
{
	for (int k = 0; k < table->count; ++k)
	{
		const Option* option = table->rows[k].option;
		if (!(given >> k & 1) || !strchr(letters, option->letter))
			continue;
		fprintf(stderr, "%s %s: --%s has no effect: %s\n", program_name, options->name, option->name, because);
		return true;
	}
	return false;
}

// Returns the row of an option. If the command does not take the option, prints an error and returns null.
static const OptionRow* find_row(const OptionTable* table, const Options* options, int letter)
{
	const OptionRow* row = table->rows;
	while (row->option->letter != letter)
		++row;
	if (row->commands & options->command)
		return row;
	fprintf(stderr, "%s %s: takes no --%s\n", program_name, options->name, row->option->name);
	return NULL;
}

// Reads the options, up to the first --help. Sets bit k of *given if the option of row k was read. Returns false after
// it has printed an error message.
static bool read_all(const OptionTable* table, Options* options, int count, char** words, const char* shorts,
                     const struct option* longs, uint64_t* given)
{
	opterr = 0;
	for (int letter; !options->help && (letter = getopt_long(count, words, shorts, longs, NULL)) != -1;)
	{
		const char* word = words[optind - 1];
		if (letter == '?')
		{
			fprintf(stderr, "%s %s: unknown option %s; %s help lists them\n", program_name, options->name, word,
			        program_name);
			return false;
		}
		if (letter == ':')
		{
			fprintf(stderr, "%s %s: %s needs a value\n", program_name, options->name, word);
			return false;
		}
		const OptionRow* row = find_row(table, options, letter);
		if (!row || !row->option->read(options, row->option, optarg))
			return false;
		*given |= (uint64_t)1 << (row - table->rows);
	}
	return true;
}

bool options_read(const OptionTable* table, Options* options, int count, char** words)
{
	struct option longs[MAX_OPTIONS + 1];
	char shorts[2 * MAX_OPTIONS + 2] = ":";
	for (int k = 0; k < table->count; ++k)
	{
		const Option* o = table->rows[k].option;
		longs[k] = (struct option){o->name, o->value ? required_argument : no_argument, NULL, o->letter};
		snprintf(shorts + strlen(shorts), 3, "%c%s", o->letter, o->value ? ":" : "");
	}
	longs[table->count] = (struct option){0};

	uint64_t given = 0;
	if (!read_all(table, options, count, words, shorts, longs, &given))
		return false;
	options->arguments = words + optind;
	options->argument_count = count - optind;
	return options->help || table->have_effect(table, options, given);
}
