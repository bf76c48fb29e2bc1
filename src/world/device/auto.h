// SPDX-License-Identifier: MIT
// auto.h -- device "auto": decides on which device a world is faster, and moves the world there. See docs/design/auto.md.
#ifndef AUTO_H
#define AUTO_H
#include "world/auto_state.h"

// Returns true if device "auto" is the CPU alone: for a world with a pool of the user, or by SCREE_AUTO.
bool auto_is_cpu(const scree_world* world);

// Turn device "auto" on and off. test: see async_open_begin.
void auto_open(scree_world* world, TestWorlds* test);
void auto_close(scree_world* world);

// Records the time of the last step. Returns whether a trial begins or ends: then auto_change must follow. Called before
// steps with dt above 0.
bool auto_choose(scree_world* world);
// Begins or ends a trial, and moves the world. Fails if the world breaks.
scree_status auto_change(scree_world* world);

// auto_clock returns the current time, ms. auto_count adds the time since `since` to the time of the current step.
double auto_clock(void);
void auto_count(scree_world* world, double since);

#endif
