// SPDX-License-Identifier: MIT
// window.h -- the window of GLFW: its context of OpenGL, and its events on their way to input.c and the panel.
#ifndef WINDOW_H
#define WINDOW_H
#include "view/window/viewer.h"

// Opens the window. Leaves a sentence when there is no display or no OpenGL 3.3.
bool window_open(Viewer* viewer, char* sentence);
void window_close(Viewer* viewer);

// The context, for scree_world_def.opengl; null when worlds cannot share with its kind.
const scree_opengl* window_opengl(Viewer* viewer);

// Waits no longer than this for events, and passes them on.
void window_events(Viewer* viewer, double seconds);

#endif
