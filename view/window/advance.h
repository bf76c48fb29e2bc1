// SPDX-License-Identifier: MIT
// advance.h -- takes the steps of the world in the viewer: those that are due in real time, and those towards a step of the time line.
#ifndef ADVANCE_H
#define ADVANCE_H
#include "view/window/window_state.h"

// Takes the steps that are due in simulated time; for a script, takes one step per frame. Steps of the past are repeated. A step
// that fails ends the viewer.
void advance(Viewer* viewer, bool scripted, double seconds);

// Takes one step towards Viewer.target: one of the past or, beyond it, the next one of a recording. Returns false on failure.
bool advance_to_target(Viewer* viewer);

#endif
