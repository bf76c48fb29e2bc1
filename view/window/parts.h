// SPDX-License-Identifier: MIT
// parts.h -- the parts of the panel, from top to bottom; in C++.
#ifndef PARTS_H
#define PARTS_H
extern "C" {
#include "view/window/window_state.h"
}

// Draw the controls of scene, parameters, pause, step and speed; the device and the hash.
void part_scene(Viewer* viewer);
void part_device(Viewer* viewer);

// Draws the graph of milliseconds, times of the stages, counters.
void part_times(const Viewer* viewer);

// Draws the controls of paint, layers and theme.
void part_look(Viewer* viewer);

// Draw the controls of the tools; of gravity, substeps and solver tuning.
void part_tools(Viewer* viewer);
void part_solver(Viewer* viewer);

#endif
