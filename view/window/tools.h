// SPDX-License-Identifier: MIT
// tools.h -- tools of the user besides dragging: throws and pours bodies, sets off blasts.
#ifndef TOOLS_H
#define TOOLS_H
#include "view/blast_tool.h"
#include "view/window/window_state.h"

#define TOOLS_DEFAULT ((Tools){.blast = BLAST_SPEED, .pour.rate = POUR_RATE})

// Throws a body in at the cursor.
void tools_launch(Viewer* viewer);

// Starts or stops pouring, for a press or a release of its key. The poured bodies get attributes of those bodies of the
// scene that have one shape and are not much larger than most.
void tools_pour(Viewer* viewer, bool down);

// Pours bodies around the cursor where there is room; call it before a step. Sets *added to true if bodies were
// created. On failure shows a message; returns false only if the device failed.
bool tools_step(Viewer* viewer, bool* added);

// Starts a blast at a press of its key, and sets it off at the release. The longer the key is down, the larger the
// blast.
void tools_blast(Viewer* viewer, bool down);

// Adds marks at the cursor: the radius of a growing blast, the area in which bodies are poured.
void tools_mark(Viewer* viewer);

#endif
