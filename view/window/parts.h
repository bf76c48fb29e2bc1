// SPDX-License-Identifier: MIT
// parts.h -- the parts of the panel, from top to bottom; in C++.
#ifndef PARTS_H
#define PARTS_H
extern "C" {
#include "view/window/window_state.h"
}

// Choose a scene, its parameters, pause, step, speed; the device and the hash.
void part_scene(Viewer* viewer);
void part_device(Viewer* viewer);

// The graph of milliseconds, times of the stages, counters.
void part_times(const Viewer* viewer);

// Paint, layers, theme.
void part_look(Viewer* viewer);

// What the cursor does; gravity, substeps, how the solver is tuned.
void part_tools(Viewer* viewer);
void part_solver(Viewer* viewer);

#endif
