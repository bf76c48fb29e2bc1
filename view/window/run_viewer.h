// SPDX-License-Identifier: MIT
// run_viewer.h -- opens the window, runs the frame loop of the viewer, closes the window.
#ifndef RUN_VIEWER_H
#define RUN_VIEWER_H
#include "view/window/view_options.h"
#include <stdio.h>

// Shows a scene until the user closes the viewer, and returns 0. On failure prints a sentence and returns an exit code:
// 1 if there is no display or no OpenGL, or if a device failed; 2 for an invalid option or scene.
int view_run(const ViewOptions* options);

// Prints the list of keys.
void view_print_keys(FILE* file);

#endif
