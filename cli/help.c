// SPDX-License-Identifier: MIT
// help.c -- prints the commands and options.
#include "help.h"
#include "validate/validate.h"
#include <string.h>
#ifdef SCREE_HAVE_WINDOW
#include "view/window/run_viewer.h"
#endif

static const struct
{
	Command command;
	const char *name, *usage, *help;
} commands[] = {
    {RUN, "run", "run SCENE|FILE", "simulate, with a table of results at the end"},
    {VIEW, "view", "view [SCENE|FILE]", "open a window on a scene, pile without a name"},
    {HASH, "hash", "hash SCENE|FILE", "simulate and print the world's hash, 16 digits, alone"},
    {SCENES, "scenes", "scenes", "list the scenes with their parameters"},
    {DEVICES, "devices", "devices", "list the devices and whether they keep the promise of equal bits"},
    {BENCH, "bench", "bench [SCENE|FILE]...", "measure scenes (all without a name), CSV on standard output"},
    {FRAMES, "frames", "bench frames SCENE|FILE", "measure steps that are drawn: docs/share.md"},
    {QUERIES, "queries", "bench queries SCENE|FILE",
     "measure rays and other queries at the end of a run: docs/queries.md"},
    {FIGURE, "figures", "bench figure5|figure6", "measure and draw the paper's figures: docs/paper.md"},
    {VALIDATE, "validate", "validate [NAME]...", "experiments: whether what must hold does: docs/validate.md"},
};
#define COMMAND_COUNT (int)(sizeof commands / sizeof commands[0])

void print_help(FILE* file)
{
	fprintf(file, "scree %s -- 2D rigid bodies, the same bits on every device\n\n", scree_version());
	for (int k = 0; k < COMMAND_COUNT; ++k)
		fprintf(file, "  scree %-28s %s\n", commands[k].usage, commands[k].help);
	fprintf(file, "  scree %-28s %s\n", "help [COMMAND]", "this text, or the options of a command");
	fprintf(file,
	        "\nscree COMMAND --help lists the options of a command as well. scree --version prints the version.\n"
	        "\nA scene is a name from `scree scenes` or the path of a JSON file. SCREE_SCENES names another folder\n"
	        "to look in first. Exit codes: 0 done, 1 a device or a file failed, or a measurement is\n"
	        "invalid, 2 bad arguments or a bad scene.\n");
}

// The keys of the window; nothing in a build without the viewer.
static void print_view_keys(FILE* file)
{
#ifdef SCREE_HAVE_WINDOW
	fprintf(file, "\nkeys of scree view\n");
	view_print_keys(file);
#else
	(void)file;
#endif
}

static void print_experiments(FILE* file)
{
	fprintf(file, "\nexperiments of scree validate\n");
	for (int k = 0; k < validate_count; ++k)
		fprintf(file, "  %-10s %s\n", validate_experiments[k].name, validate_experiments[k].shows);
}

void print_command_help(FILE* file, Command command)
{
	// bench is a command, and the first word of other commands
	for (int k = 0; k < COMMAND_COUNT; ++k)
	{
		if (commands[k].command == command || (command == BENCH && strncmp(commands[k].usage, "bench ", 6) == 0))
			fprintf(file, "  scree %-28s %s\n", commands[k].usage, commands[k].help);
	}
	fprintf(file, "\n");
	for (int k = 0; k < option_count; ++k)
	{
		char usage[64];
		snprintf(usage, sizeof usage, "--%s %s", option_rows[k].name, option_rows[k].value ? option_rows[k].value : "");
		if (option_rows[k].commands & command)
			fprintf(file, "  -%c, %-26s %s\n", option_rows[k].letter, usage, option_rows[k].help);
	}
	if (command == VIEW)
		print_view_keys(file);
	if (command == VALIDATE)
		print_experiments(file);
}
