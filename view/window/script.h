// SPDX-License-Identifier: MIT
// script.h -- a file of user actions, for tests and for pictures of the window.
#ifndef SCRIPT_H
#define SCRIPT_H
#include "view/window/window_state.h"
#include <stdio.h>

typedef struct // docs/view.md has the words
{
	FILE* file; // null: no script
	const char* path;
	int line;
	int frames;       // to draw before the next line
	char awaited[16]; // state that the script waits for; empty for none
	double until;     // s: when waiting fails
} Script;

// Opens the file; a null path is no script. False writes a sentence.
bool script_open(Script* script, const char* path, char* sentence);
void script_close(Script* script);

// Before each frame: runs the lines that are due. The end of the file ends the viewer.
void script_run(Script* script, Viewer* viewer);

#endif
