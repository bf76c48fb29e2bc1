// SPDX-License-Identifier: MIT
// idle.h -- finds the blocks of bodies and of collidables that no step changes, so that a CPU skips them.
//
// A level of a game has many static bodies and few that move. For unchanged static bodies, the kernels over all bodies
// and all collidables would write the values that are already stored. A block of them is idle if it contains only
// static items and free slots, and some steps have passed since the last change. The results have the same bits.
#ifndef IDLE_H
#define IDLE_H
#include "scree/scree.h"

// Marks the blocks that the pending edits change. Called before the upload.
void idle_note(scree_world* world);

// Makes all blocks not idle until they are examined again, because the pools are on another device.
void idle_forget(scree_world* world);

// Passes the blocks that are not idle to the backend. Called before a step.
void idle_begin(scree_world* world);

// Updates the states of the blocks. Called after a step with dt above 0.
void idle_end(scree_world* world);

void idle_close(scree_world* world);

#endif
