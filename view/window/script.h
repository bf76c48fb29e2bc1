// SPDX-License-Identifier: MIT
// script.h -- runs a file of user actions, for tests and for pictures of the window.
#ifndef SCRIPT_H
#define SCRIPT_H
#include "view/window/window_state.h"
#include <stdio.h>

typedef struct // docs/manual/view.md describes the commands of a script
{
	FILE* file; // null: no script
	const char* path;
	int line;
	int frames;       // number of frames that are drawn before the next line
	char awaited[16]; // state that the viewer must reach before the next line; empty: no state
	double until;     // s: time at which the script fails if the state is not reached
} Script;

// Opens the file; a null path means no script. Returns false and writes a sentence on failure.
bool script_open(Script* script, const char* path, char* sentence);
void script_close(Script* script);

// Runs the lines that are due. Call it before each frame. After the last line the viewer ends.
void script_run(Script* script, Viewer* viewer);

#endif
