// SPDX-License-Identifier: MIT
// window.h -- the GLFW window: its OpenGL context, and its events, which go to input.c and the panel.
#ifndef WINDOW_H
#define WINDOW_H
#include "view/window/window_state.h"

// Opens the window. False writes a sentence: there is no display or no OpenGL 3.3.
bool window_open(Viewer* viewer, char* sentence);
void window_close(Viewer* viewer);

// The context for scree_world_def.opengl. Null: worlds cannot share memory with this kind of context.
const scree_opengl* window_opengl(Viewer* viewer);

// Waits at most this many seconds for events and handles them.
void window_events(Viewer* viewer, double seconds);

// Writes what is shown into the title of the window, now and then.
void window_title(Viewer* viewer);

#endif
