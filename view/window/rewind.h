// SPDX-License-Identifier: MIT
// rewind.h -- the time line of the viewer: goes back to a past step, with the tools and the characters at that step.
#ifndef REWIND_H
#define REWIND_H
#include "view/window/window_state.h"

// Begins the time line at the current step, after a world was loaded.
void rewind_begin(Viewer* viewer);

// Ends the time line, before the world is destroyed.
void rewind_end(Viewer* viewer);

// Adds the step that the world has taken.
void rewind_add(Viewer* viewer);

// Returns true while the world is at a past step, from which the recorded steps go on.
bool rewind_repeats(const Viewer* viewer);

// Goes to a step of the time line: sets it as the target, to which rewind_step takes steps. Steps are those of the world.
// Returns false if the world is too large to go back.
bool rewind_to(Viewer* viewer, int64_t step);

// Returns true if the target is a later step of a recording, and the world is at the last step that it has taken.
bool rewind_beyond(const Viewer* viewer);

// Takes a step of the past towards the target, or by one if there is none. Returns false on failure; scree_error() has the reason.
bool rewind_step(Viewer* viewer);

// Drops the steps after the current one, before a change by the user. A body that was held at that step is released.
void rewind_cut(Viewer* viewer);

// Returns the first and the last step of the time line in *first and *end; that of a recording ends with its last step. Returns
// false if the world is too large to go back.
bool rewind_span(const Viewer* viewer, int64_t* first, int64_t* end);

#endif
