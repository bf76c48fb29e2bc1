// SPDX-License-Identifier: MIT
// idle.h -- which blocks of bodies and of collidables no step changes, so that a CPU leaves them out.
//
// A level of a game has many static bodies and few that move. For a static body that nobody changes, the stages over all bodies
// and all collidables write what is there already. Bodies and collidables are looked at in blocks: a block is idle when all of
// it is static or free of bodies, and some steps have passed since the last change. The result is the same bits as without.
#ifndef IDLE_H
#define IDLE_H
#include "scree/scree.h"

// Notes what waits for the upload. Called before it.
void idle_note(scree_world* world);

// Nothing is idle until it was looked at again: the pools lie on another device.
void idle_forget(scree_world* world);

// Before a step: tells the backend which blocks are not idle.
void idle_begin(scree_world* world);

// After a step that took time.
void idle_end(scree_world* world);

void idle_close(scree_world* world);

#endif
