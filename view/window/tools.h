// SPDX-License-Identifier: MIT
// tools.h -- what the user does to the world besides dragging: throws bodies in, pours them, sets off explosions.
#ifndef TOOLS_H
#define TOOLS_H
#include "view/blast_tool.h"
#include "view/window/window_state.h"

#define TOOLS_DEFAULT ((Tools){.blast = BLAST_SPEED, .pour.rate = POUR_RATE})

// Throws a body in at the cursor.
void tools_launch(Viewer* viewer);

// The key for pouring goes down or up. Bodies are like those of the scene that have one shape and are not much larger than most.
void tools_pour(Viewer* viewer, bool down);

// Before a step: pours bodies around the cursor where there is room. False if it failed, with a message.
bool tools_step(Viewer* viewer, bool* added);

// The key for explosions goes down or up. The longer it was down, the larger the explosion.
void tools_blast(Viewer* viewer, bool down);

// Shows what would happen at the cursor.
void tools_mark(Viewer* viewer);

#endif
