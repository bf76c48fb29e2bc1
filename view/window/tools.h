// SPDX-License-Identifier: MIT
// tools.h -- tools of the user other than dragging: throwing and pouring bodies, blasts.
#ifndef TOOLS_H
#define TOOLS_H
#include "view/blast_tool.h"
#include "view/window/window_state.h"

#define TOOLS_DEFAULT ((Tools){.blast = BLAST_SPEED, .pour.rate = POUR_RATE})

// Throws a body in at the cursor.
void tools_launch(Viewer* viewer);

// Handles the key for pouring. Poured bodies have attributes of bodies of the scene: those with one shape that are not
// much larger than most.
void tools_pour(Viewer* viewer, bool down);

// Pours bodies around the cursor where there is room; call it before a step. On failure it shows a message; returns
// false only if the device failed.
bool tools_step(Viewer* viewer, bool* added);

// Handles the key for blasts. The longer it is down, the larger the blast.
void tools_blast(Viewer* viewer, bool down);

// Shows the effect that the tools would have at the cursor.
void tools_mark(Viewer* viewer);

#endif
