// SPDX-License-Identifier: MIT
// main.c -- the command line of Scree.
#include "commands.h"
#include "help.h"
#include <errno.h>
#include <string.h>
#include <unistd.h>

static const struct
{
	const char* name;
	Command command;
	int low, high; // number of arguments
	int (*function)(const Options* options);
} commands[] = {
    {"run", RUN, 1, 1, run_command},
    {"hash", HASH, 1, 1, hash_command},
    {"scenes", SCENES, 0, 0, scenes_command},
    {"devices", DEVICES, 0, 0, devices_command},
    {"view", VIEW, 0, 1, view_command},
    {"bench frames", FRAMES, 1, 1, frames_command},
    {"bench queries", QUERIES, 1, 1, queries_command},
    {"bench figure5", FIGURE, 0, 0, figure5_command},
    {"bench figure6", FIGURE, 0, 0, figure6_command},
    {"bench", BENCH, 0, 1000, bench_command},
    {"validate", VALIDATE, 0, 1000, validate_command},
};

// The path of this program; scenes may lie beside it.
static const char* executable_path(const char* first_word, char* text, size_t size)
{
	ssize_t length = readlink("/proc/self/exe", text, size - 1);
	if (length <= 0)
		return first_word;
	text[length] = 0;
	return text;
}

// The number of words of a command's name, if words[1] and perhaps words[2] are that name; else 0.
static int match(const char* name, int count, char** words)
{
	size_t first = strcspn(name, " ");
	if (strlen(words[1]) != first || strncmp(words[1], name, first) != 0)
		return 0;
	if (!name[first])
		return 1;
	return count > 2 && strcmp(words[2], name + first + 1) == 0 ? 2 : 0;
}

// The number of the command whose name begins at words[1], -1 for none; named is its number of words.
static int find_command(int count, char** words, int* named)
{
	for (int k = 0; k < (int)(sizeof commands / sizeof commands[0]); ++k)
	{
		*named = match(commands[k].name, count, words);
		if (*named > 0)
			return k;
	}
	return -1;
}

static int run_named(int count, char** words, const char* executable)
{
	int named, k = find_command(count, words, &named);
	if (k < 0)
	{
		fprintf(stderr, "scree: unknown command \"%s\"; scree help lists them\n", words[1]);
		return EXIT_BAD;
	}
	Options options = {.executable = executable, .command = commands[k].command, .name = commands[k].name};
	options.device = "auto";
	options.width = 1600;
	options.height = 900;
	options.repeats = 3;
	if (!options_read(&options, count - named, words + named))
		return EXIT_BAD;
	if (options.help)
	{
		print_command_help(stdout, options.command);
		return EXIT_GOOD;
	}
	if (options.argument_count < commands[k].low || options.argument_count > commands[k].high)
	{
		fprintf(stderr, "scree %s: %d arguments, takes %s\n", commands[k].name, options.argument_count,
		        commands[k].high == 0 ? "none" : "one scene");
		return EXIT_BAD;
	}
	return commands[k].function(&options);
}

// scree help COMMAND.
static int explain(int count, char** words)
{
	int named, k = find_command(count - 1, words + 1, &named);
	if (k < 0 || named != count - 2)
	{
		fprintf(stderr, "scree help: unknown command \"%s\"; scree help lists them\n", words[2]);
		return EXIT_BAD;
	}
	print_command_help(stdout, commands[k].command);
	return EXIT_GOOD;
}

int main(int count, char** words)
{
	char executable[SCENE_PATH];
	int code = EXIT_GOOD;
	if (count < 2)
	{
		print_help(stderr);
		return EXIT_BAD;
	}
	if (count > 2 && strcmp(words[1], "help") == 0)
		code = explain(count, words);
	else if (strcmp(words[1], "help") == 0 || strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0)
		print_help(stdout);
	else if (strcmp(words[1], "--version") == 0)
		printf("%s\n", scree_version());
	else
		code = run_named(count, words, executable_path(words[0], executable, sizeof executable));

	if ((fflush(stdout) != 0 || ferror(stdout)) && code == EXIT_GOOD)
	{
		fprintf(stderr, "scree: cannot write to standard output: %s\n", strerror(errno));
		code = EXIT_FAILED;
	}
	return code;
}
