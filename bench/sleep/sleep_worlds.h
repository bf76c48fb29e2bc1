// SPDX-License-Identifier: MIT
// sleep_worlds.h -- builds the worlds of scree_sleep: pyramids on shelves, falling balls, one large pyramid.
#ifndef SLEEP_WORLDS_H
#define SLEEP_WORLDS_H
#include "sleep_run.h"

#define STANDARD_SLEEPERS 990000  // 18,000 pyramids; a change makes docs/measurements/sleep.md that of another world
#define LARGE_SLEEPERS    9955000 // 181,000 pyramids; the same
#define MAX_ROWS          200     // maximum number of rows of a pyramid

// Creates the world of a run. Returns false after printing a message; the caller calls sleep_world_close also then.
bool sleep_world_open(SleepRun* run);
void sleep_world_close(SleepRun* run);

// Builds pyramids of 55 boxes on shelves, some of them awake, and balls that fall below the lowest shelf.
bool build_field(SleepRun* run);

// Builds one pyramid of setting->rows rows, and takes steps until it sleeps.
bool build_pyramid(SleepRun* run);

// Returns the number of sleeping pyramids in the field of a run.
int sleeping_pyramids(const SleepRun* run);

// Returns the middle of the base of a sleeping pyramid in the field of a run, m. number: from 0.
scree_vec sleeping_place(const SleepRun* run, int number);

#endif
