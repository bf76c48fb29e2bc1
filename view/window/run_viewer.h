// SPDX-License-Identifier: MIT
// run_viewer.h -- the viewer from start to end: opens the window, runs its frame loop, closes it.
#ifndef RUN_VIEWER_H
#define RUN_VIEWER_H
#include "view/window/view_options.h"
#include <stdio.h>

// Shows a scene until the user closes the viewer, and returns 0. On failure it prints a sentence and returns 1 (no
// display, no OpenGL, a device failed) or 2 (an invalid option or scene).
int view_run(const ViewOptions* options);

// Prints the list of keys.
void view_print_keys(FILE* file);

#endif
