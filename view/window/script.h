// SPDX-License-Identifier: MIT
// script.h -- a file of what a user would do, for tests and for pictures of the window.
#ifndef SCRIPT_H
#define SCRIPT_H
#include <stdbool.h>
#include <stdio.h>

typedef struct Script // docs/view.md has the words
{
	FILE* file; // null when there is none
	const char* path;
	int line;
	int frames;       // still to be drawn before the next line
	char awaited[16]; // what the next line waits for; empty for nothing
	double until;     // s: no longer than this
} Script;

struct Viewer;

// Opens the file; a null path is no script. False leaves a sentence.
bool script_open(Script* script, const char* path, char* sentence);
void script_close(Script* script);

// Before a frame: does what its time has come for. Behind the last line the viewer is done.
void script_go(Script* script, struct Viewer* viewer);

#endif
