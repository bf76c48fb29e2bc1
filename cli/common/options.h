// SPDX-License-Identifier: MIT
// options.h -- holds the values of all options of a command, and reads them with a table of options.
#ifndef OPTIONS_H
#define OPTIONS_H
#include "scene/scene.h"
#include <stdbool.h>

#define MAX_SETTINGS 32
#define MAX_OPTIONS  64 // maximum number of rows of a table: one bit of an uint64_t per row

// exit codes
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // failure of a device, a written file or memory, or an invalid measurement
#define EXIT_BAD    2 // invalid command line, or a scene or another file that cannot be read; nothing was simulated

extern const char* program_name; // beginning of each message; set by command_line_run

typedef struct
{
	const char* executable;
	int command;      // a bit of OptionRow.commands
	const char* name; // name of the command as the user wrote it
	int steps;        // 0: the number of steps in the scene
	const char* device;
	int threads, lanes; // 0: as many as available
	bool allow_unequal_bits;
	SceneSleep sleep;
	int recovery_interval;                 // as in scree_world_def
	const scree_opengl* opengl;            // context that draws the world; null if there is none
	const char *picture, *video, *csv;     // paths; null: no such file is written
	const char *renderer, *paint, *layers; // names; null: the default value
	bool dark;                             // dark theme
	float scale;                           // scale of the panel; 0: scale of the display
	const char* script;                    // path of a file with actions of the user; null: none
	int width, height;                     // px
	bool has_view, has_zoom;               // true if the option was given; otherwise the scene's view is shown
	scree_box view, zoom;                  // m: part of the world in pictures at the start, and at the end
	int repeats;
	const char *save, *load; // paths of snapshots; null: none
	const char* write_scene; // path of a scene file; null: none
	const char* record;      // path of a recording; null: none
	int hash_interval;       // steps from one hash of the recording to the next
	const char* against;     // device of a second world; null: none
	int queries;             // 0: 1,000,000 queries
	int worlds;              // number of worlds of a batch; 0: no batch
	int show;                // number of the world that is taken out of a batch
	int template_steps;      // steps of the template of a batch before it is copied
	float resets;            // percentage of the worlds of a batch that are reset before each step
	bool inputs;             // random inputs of the worlds of a batch before each step
	int columns;             // largest number of columns of the outputs of a batch
	int batches;             // number of batches that step the worlds at the same time
	int part, parts;         // this part of the worlds of a batch, 1 to parts
	const char* known;       // path of a CSV with expected hashes; null: none
	bool names, test, whole, quick;
	bool help; // true: the command prints its help; the options after --help were not read
	SceneSetting settings[MAX_SETTINGS];
	int setting_count;
	char** arguments; // words that are not options
	int argument_count;
} Options;

typedef struct Option
{
	const char* name;
	char letter;
	const char* value; // name of the value in the help; null for a switch
	const char* help;
	bool (*read)(Options* options, const struct Option* option, char* value); // returns false after an error message
	size_t offset; // offset of the member that a switch, a text or a number sets
	int most;      // maximum of a number; the minimum is 1
} Option;

typedef struct
{
	const Option* option;
	int commands; // bits of the commands that take the option
} OptionRow;

typedef struct OptionTable // options of a program
{
	const OptionRow* rows;
	int count;
	// Returns whether each given option has an effect; if one has none, prints the reason. given: bit k for row k.
	bool (*have_effect)(const struct OptionTable* table, const Options* options, uint64_t given);
} OptionTable;

// Returns the number of steps of a command: that of the command line, or that of the scene.
static inline int options_steps(const Options* options, const Scene* scene)
{
	return options->steps > 0 ? options->steps : scene->steps;
}

// Reads the words after the command's name. options: Options, or a struct that begins with Options. On failure it
// prints an error message and returns false.
bool options_read(const OptionTable* table, Options* options, int count, char** words);

// If an option with one of these letters was given, prints that it has no effect, with the reason `because`, and
// returns true. Otherwise returns false.
bool options_no_effect(const OptionTable* table, const Options* options, uint64_t given, const char* letters,
                       const char* because);

#endif
