// SPDX-License-Identifier: MIT
// tools.h -- tools of the user besides dragging: throws and pours bodies, sets off blasts.
#ifndef TOOLS_H
#define TOOLS_H
#include "view/blast_tool.h"
#include "view/window/window_state.h"

#define TOOLS_DEFAULT ((Tools){.blast = BLAST_SPEED, .pour.rate = POUR_RATE})

// Throws a body in at the cursor.
void tools_launch(Viewer* viewer);

// Removes the selected body, or shows the reason why it stays.
void tools_remove(Viewer* viewer);

// Starts pouring when its key is pressed, and stops when the key is released. The poured bodies get attributes of those
// bodies of the scene that have one shape and a reach of at most four times the median.
void tools_pour(Viewer* viewer, bool down);

// Pours bodies around the cursor where there is room; call it before a step. Sets *added to true if bodies were
// created. On failure shows a message; returns false only if the device failed.
bool tools_step(Viewer* viewer, bool* added);

// Starts a blast when its key is pressed, and sets it off when the key is released. The longer the key is down, the
// larger the blast.
void tools_blast(Viewer* viewer, bool down);

// Adds marks at the cursor: the radius of a growing blast, the area in which bodies are poured.
void tools_mark(Viewer* viewer);

#endif
