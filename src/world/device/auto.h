// SPDX-License-Identifier: MIT
// auto.h -- device "auto": where a world is faster, and how it gets there; docs/auto.md.
#ifndef AUTO_H
#define AUTO_H
#include "world/auto_state.h"

// Turns device "auto" on and off. compare is that of async_open_begin.
void auto_open(scree_world* world, CompareDevice* compare);
void auto_close(scree_world* world);

// Called before a step: records the time of the last one, and moves the world when that pays. Fails only when the world
// breaks.
scree_status auto_choose(scree_world* world);

// The clock, ms. auto_count adds the time since then to the current step.
double auto_clock(void);
void auto_count(scree_world* world, double since);

#endif
