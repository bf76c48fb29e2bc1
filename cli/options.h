// SPDX-License-Identifier: MIT
// options.h -- the commands and options of the command line.
#ifndef OPTIONS_H
#define OPTIONS_H
#include "scene/scene.h"
#include <stdbool.h>

#define MAX_SETTINGS 32

// exit codes
#define EXIT_GOOD   0
#define EXIT_FAILED 1 // a device, a file or memory failed, or a measurement is invalid
#define EXIT_BAD    2 // a bad command line or scene; nothing was simulated

typedef enum // bits, so that an option can belong to several commands
{
	RUN = 1,
	HASH = 2,
	SCENES = 4,
	DEVICES = 8,
	BENCH = 16,
	VIEW = 32,
	FRAMES = 64,  // bench frames
	FIGURE = 128, // bench figure5, bench figure6
	VALIDATE = 256,
	QUERIES = 512, // bench queries
} Command;

typedef enum
{
	PIPELINE_SOFT,  // the soft step solver of libscree
	PIPELINE_PAPER, // integrate, transform, detect, resolve, as in the paper
} PipelineChoice;

typedef struct
{
	const char* executable;
	Command command;
	const char* name; // of the command, as the user wrote it
	int steps;        // 0: as the scene says
	const char* device;
	int threads, lanes; // 0: as many as there are
	PipelineChoice pipeline;
	bool allow_unequal_bits;
	const scree_opengl* opengl;            // context that draws the world; null for none
	const char *picture, *video, *csv;     // null: none
	const char *renderer, *paint, *layers; // null: the default
	bool dark;                             // theme
	float scale;                           // of the panel; 0: as the display says
	const char* script;                    // null: none
	int width, height;                     // px
	bool has_view, has_zoom;               // else as the scene says, and for the whole run
	scree_box view, zoom;                  // m: what pictures show, at the start of the run and at its end
	int repeats;
	int queries;       // 0: a million
	int limit;         // most bodies in a figure; 0: no limit
	const char* draw;  // CSV of a figure; null: measure
	const char* known; // CSV of expected hashes; null: none
	bool names, whole, quick;
	bool help; // of the command; the other options were not all read
	SceneSetting settings[MAX_SETTINGS];
	int setting_count;
	char** arguments; // words that are no options
	int argument_count;
	// not on the command line: the figures set these
	int warm_up;             // steps of the soft pipeline before the pipeline is opened
	const char* warm_device; // device of these steps; null: that of the simulation
} Options;

typedef struct OptionRow // of the table of options
{
	const char* name;
	char letter;
	const char* value; // null for a switch
	int commands;      // bits of Command
	const char* help;
	bool (*read)(Options* options, const struct OptionRow* row, char* value); // false after printing a sentence
	size_t offset; // of the member of Options that a switch, a text or a number sets
	int most;      // of a number; the least is 1
} OptionRow;

extern const OptionRow option_rows[];
extern const int option_count;

// The steps that a command takes: those asked for, or as many as the scene says.
static inline int options_steps(const Options* options, const Scene* scene)
{
	return options->steps > 0 ? options->steps : scene->steps;
}

// Reads the words after the command's name. False after printing a sentence.
bool options_read(Options* options, int count, char** words);

#endif
