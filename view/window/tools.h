// SPDX-License-Identifier: MIT
// tools.h -- tools of the user besides dragging: throws and pours bodies, sets off blasts.
#ifndef TOOLS_H
#define TOOLS_H
#include "view/blast_tool.h"
#include "view/window/window_state.h"

#define TOOLS_DEFAULT ((Tools){.blast = BLAST_SPEED, .pour.rate = POUR_RATE})

// Throws a body in at the cursor.
void tools_launch(Viewer* viewer);

// Handles the key for pouring. The attributes of poured bodies are those of the scene's bodies that have one shape and
// are not much larger than most.
void tools_pour(Viewer* viewer, bool down);

// Pours bodies around the cursor where there is room; call it before a step. Sets added to true if bodies were added.
// On failure shows a message; returns false only if the device failed.
bool tools_step(Viewer* viewer, bool* added);

// Handles the key for blasts. The longer the key is down, the larger the blast.
void tools_blast(Viewer* viewer, bool down);

// Adds marks at the cursor: the radius of a growing blast, the area in which bodies are poured.
void tools_mark(Viewer* viewer);

#endif
