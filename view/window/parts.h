// SPDX-License-Identifier: MIT
// parts.h -- draws the parts of the panel, from top to bottom; in C++.
#ifndef PARTS_H
#define PARTS_H
extern "C" {
#include "view/window/window_state.h"
}

// Draw parts: controls of scene, parameters, pause, step and speed (part_scene); device and hash (part_device).
void part_scene(Viewer* viewer);
void part_device(Viewer* viewer);

// Draws the graph of milliseconds, the times of the stages, and the counters.
void part_times(const Viewer* viewer);

// Draws the controls of paint, layers and theme.
void part_look(Viewer* viewer);

// Draw parts: controls of the tools (part_tools); gravity, substeps and solver tuning (part_solver).
void part_tools(Viewer* viewer);
void part_solver(Viewer* viewer);

#endif
