// SPDX-License-Identifier: MIT
// idle.h -- finds the blocks of bodies and of collidables that no step changes, so that a CPU can skip them. For
// unchanged static bodies, kernels would only write values that are already stored. So a block is idle if it has only
// static items and free slots, and some steps have passed since its last change. Skipping it changes no results.
#ifndef IDLE_H
#define IDLE_H
#include "scree/scree.h"

// Marks the blocks of pending edits as active. The caller uploads the edits afterwards.
void idle_note(scree_world* world);

// Marks all blocks as active, because the world has moved to another device.
void idle_forget(scree_world* world);

// Passes the active blocks to the backend. Must be called before each step.
void idle_begin(scree_world* world);

// Updates the states of the blocks. Must be called after each step whose dt is above 0.
void idle_end(scree_world* world);

void idle_close(scree_world* world);

#endif
