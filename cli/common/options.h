// SPDX-License-Identifier: MIT
// options.h -- the options of a command, and the table by which they are read.
#ifndef OPTIONS_H
#define OPTIONS_H
#include "scene/scene.h"
#include <stdbool.h>

#define MAX_SETTINGS 32
#define MAX_OPTIONS  32 // rows of a table: a bit of an unsigned for each

// exit codes
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // a device, a file or memory failed, or a measurement is invalid
#define EXIT_BAD    2 // a bad command line or scene; nothing was simulated

extern const char* program_name; // begins each message; command_line_run sets it

typedef struct
{
	const char* executable;
	int command;      // a bit of OptionRow.commands
	const char* name; // the command's, as the user wrote it
	int steps;        // 0: as the scene says
	const char* device;
	int threads, lanes; // 0: as many as there are
	bool allow_unequal_bits;
	const scree_opengl* opengl;            // context that draws the world; null for none
	const char *picture, *video, *csv;     // null: none
	const char *renderer, *paint, *layers; // null: the default
	bool dark;                             // theme
	float scale;                           // size of the panel; 0: as the display says
	const char* script;                    // null: none
	int width, height;                     // px
	bool has_view, has_zoom;               // else as the scene says, and for the whole run
	scree_box view, zoom;                  // m: what pictures show, at the start of the run and at its end
	int repeats;
	int queries;       // 0: a million
	const char* known; // CSV of expected hashes; null: none
	bool names, whole, quick;
	bool help; // print the help of the command; the other options were not all read
	SceneSetting settings[MAX_SETTINGS];
	int setting_count;
	char** arguments; // words that are no options
	int argument_count;
} Options;

typedef struct Option
{
	const char* name;
	char letter;
	const char* value; // null for a switch
	const char* help;
	bool (*read)(Options* options, const struct Option* option, char* value); // false after printing a sentence
	size_t offset; // place of the member that a switch, a text or a number sets
	int most;      // greatest number; the least is 1
} Option;

typedef struct
{
	const Option* option;
	int commands; // a bit for each that takes it
} OptionRow;

typedef struct OptionTable // the options of a program
{
	const OptionRow* rows;
	int count;
	// Checks the options together; given has a bit for each row. False after printing why one has no effect.
	bool (*have_effect)(const struct OptionTable* table, const Options* options, unsigned given);
} OptionTable;

// Returns the number of steps of a command: that of --steps, or that of the scene.
static inline int options_steps(const Options* options, const Scene* scene)
{
	return options->steps > 0 ? options->steps : scene->steps;
}

// Reads the words after the command's name. options: Options, or a struct that begins with them. False after printing a sentence.
bool options_read(const OptionTable* table, Options* options, int count, char** words);

// Whether one of the options with these letters was given; if so, prints why it has no effect.
bool options_no_effect(const OptionTable* table, const Options* options, unsigned given, const char* letters,
                       const char* because);

#endif
