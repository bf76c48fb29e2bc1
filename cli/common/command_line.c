// SPDX-License-Identifier: MIT
// command_line.c -- reads the command line of a program: runs the command that its first words name, or prints help.
#include "command_line.h"
#include <errno.h>
#include <string.h>
#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <unistd.h>
#endif

static void print_command(FILE* file, const CommandLine* line, const Command* command)
{
	fprintf(file, "  %s %-28s %s\n", line->name, command->usage, command->help);
}

static void print_help(FILE* file, const CommandLine* line)
{
	fprintf(file, "%s %s -- %s\n\n", line->name, scree_version(), line->title);
	for (int k = 0; k < line->command_count; ++k)
		print_command(file, line, &line->commands[k]);
	fprintf(file, "  %s %-28s %s\n", line->name, "help [COMMAND]", "print this text, or the options of a command");
	fprintf(file,
	        "\n%s COMMAND --help lists the options of a command as well. %s --version prints the version.\n"
	        "\nA scene is a name from `scree scenes` or the path of a JSON file. The environment variable\n"
	        "SCREE_SCENES names a folder that is searched first. Exit codes: 0 success; 1 failure of a device, a\n"
	        "file that cannot be written, or an invalid measurement; 2 invalid arguments, or a scene or another\n"
	        "file that cannot be read.\n",
	        line->name, line->name);
}

static void print_command_help(FILE* file, const CommandLine* line, const Command* command)
{
	// prints also the commands of two words that begin with this name, such as "bench frames" for bench
	size_t length = strlen(command->name);
	for (const Command* c = line->commands; c < line->commands + line->command_count; ++c)
		if (strncmp(c->name, command->name, length) == 0 && (c->name[length] == ' ' || !c->name[length]))
			print_command(file, line, c);
	fprintf(file, "\n");
	for (const OptionRow* row = line->options.rows; row < line->options.rows + line->options.count; ++row)
	{
		char usage[64];
		const Option* option = row->option;
		snprintf(usage, sizeof usage, "--%s %s", option->name, option->value ? option->value : "");
		if (row->commands & command->bit)
			fprintf(file, "  -%c, %-26s %s\n", option->letter, usage, option->help);
	}
	if (command->print_more)
		command->print_more(file);
}

// Returns the path of this program, so that scenes can be found in a folder next to it.
static const char* executable_path(const char* first_word, char* text, size_t size)
{
#ifdef _WIN32
	DWORD length = GetModuleFileNameA(NULL, text, (DWORD)size);
	if (length == 0 || length == size)
		return first_word;
#else
	ssize_t length = readlink("/proc/self/exe", text, size - 1);
	if (length <= 0)
		return first_word;
	text[length] = 0;
#endif
	return text;
}

// Returns 1 if the name of a command is words[1], 2 if it is words[1] and words[2], otherwise 0. count: number of
// words.
static int match(const char* name, int count, char** words)
{
	size_t first = strcspn(name, " ");
	if (strlen(words[1]) != first || strncmp(words[1], name, first) != 0)
		return 0;
	if (!name[first])
		return 1;
	return count > 2 && strcmp(words[2], name + first + 1) == 0 ? 2 : 0;
}

// Returns the command whose name is words[1], or words[1] and words[2]; the longer name wins. Returns null if there is
// no such command. *named: number of words of the name.
static const Command* find_command(const CommandLine* line, int count, char** words, int* named)
{
	const Command* found = NULL;
	*named = 0;
	for (int k = 0; k < line->command_count; ++k)
	{
		int length = match(line->commands[k].name, count, words);
		if (length > *named)
		{
			*named = length;
			found = &line->commands[k];
		}
	}
	return found;
}

static int run_named(const CommandLine* line, Options* options, int count, char** words)
{
	int named;
	const Command* command = find_command(line, count, words, &named);
	if (!command)
	{
		fprintf(stderr, "%s: unknown command \"%s\"; %s help lists them\n", line->name, words[1], line->name);
		return EXIT_BAD;
	}
	options->command = command->bit;
	options->name = command->name;
	if (!options_read(&line->options, options, count - named, words + named))
		return EXIT_BAD;
	if (options->help)
	{
		print_command_help(stdout, line, command);
		return EXIT_GOOD;
	}
	if (options->argument_count < command->least || options->argument_count > command->most)
	{
		const char* noun = strstr(command->usage, " FILE") && !strstr(command->usage, "SCENE") ? "file" : "scene";
		char takes[32] = "no arguments";
		if (command->most == 1)
			snprintf(takes, sizeof takes, "one %s", noun);
		else if (command->most > 1)
			snprintf(takes, sizeof takes, command->most == 2 ? "two %ss" : "one %s or more", noun);
		if (options->argument_count > command->most)
			fprintf(stderr, "%s %s: unexpected argument \"%s\"; the command takes %s\n", line->name, command->name,
			        options->arguments[command->most], takes);
		else
			fprintf(stderr, "%s %s: a %s is missing; the command takes %s\n", line->name, command->name, noun, takes);
		return EXIT_BAD;
	}
	return command->run(options);
}

// Prints the help of the command whose name follows the word help. Returns an exit code.
static int explain(const CommandLine* line, int count, char** words)
{
	int named;
	const Command* command = find_command(line, count - 1, words + 1, &named);
	if (!command || named != count - 2)
	{
		fprintf(stderr, "%s help: unknown command \"%s\"; %s help lists them\n", line->name, words[2], line->name);
		return EXIT_BAD;
	}
	print_command_help(stdout, line, command);
	return EXIT_GOOD;
}

int command_line_run(const CommandLine* line, Options* options, int count, char** words)
{
	char executable[SCENE_PATH];
	int code = EXIT_GOOD;
	if (count < 2)
	{
		print_help(stderr, line);
		return EXIT_BAD;
	}
	program_name = line->name;
	options->executable = executable_path(words[0], executable, sizeof executable);
	bool help = strcmp(words[1], "help") == 0;
	if (help && count > 2 && strcmp(words[2], "--help") != 0 && strcmp(words[2], "-h") != 0)
		code = explain(line, count, words);
	else if (help || strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0)
		print_help(stdout, line);
	else if (strcmp(words[1], "--version") == 0)
		printf("%s\n", scree_version());
	else
		code = run_named(line, options, count, words);

	if ((fflush(stdout) != 0 || ferror(stdout)) && code == EXIT_GOOD)
	{
		fprintf(stderr, "%s: cannot write to standard output: %s\n", line->name, strerror(errno));
		code = EXIT_FAILED;
	}
	return code;
}
