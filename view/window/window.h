// SPDX-License-Identifier: MIT
// window.h -- opens the GLFW window with its OpenGL context, and sends its events to input.c and the panel.
#ifndef WINDOW_H
#define WINDOW_H
#include "view/window/window_state.h"

// Opens the window. Returns false and writes a sentence if there is no display or no OpenGL 3.3.
bool window_open(Viewer* viewer, char* sentence);
void window_close(Viewer* viewer);

// Returns the context for scree_world_def.opengl; null if worlds cannot share memory with this kind of context.
const scree_opengl* window_opengl(Viewer* viewer);

// Blocks until there are events, but at most for this time in seconds. Then handles the events.
void window_events(Viewer* viewer, double seconds);

// Writes the state of the viewer into the title of the window, at most every 0.5 s.
void window_title(Viewer* viewer);

#endif
