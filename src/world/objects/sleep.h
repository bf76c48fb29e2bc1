// SPDX-License-Identifier: MIT
// sleep.h -- computes thresholds of sleep, and records commands that wake bodies.
#ifndef SLEEP_H
#define SLEEP_H
#include "world/world.h"

// Returns the value of the pool sleep_threshold for a body.
float body_sleep_threshold(const HostBody* host);

// Records a command that wakes a body (index below 0: none) if bodies may sleep. The caller has reserved memory for one
// command.
void body_note_wake(scree_world* world, int index);

#endif
