// SPDX-License-Identifier: MIT
// auto.h -- device "auto": where a world would be faster, and its way there; docs/auto.md.
#ifndef AUTOMATIC_H
#define AUTOMATIC_H
#include "backend/backend.h"
#include "world/open_async.h"

#define RECENT_STEPS 7

typedef struct // what a step costs on one device
{
	double recent[RECENT_STEPS]; // ms of the last steps, in no order
	int count;                   // steps since the world came
	double step;                 // ms, as of the last comparison; 0 before the first
	int work;                    // of the world then: bodies and contacts
} Meter;

typedef struct
{
	bool on;            // the device was given as "auto"
	char named[160];    // by SCREE_AUTO: the device to try at once; empty for a GPU when it may pay
	AsyncOpen* opening; // of the other device; null when none is being opened
	Backend* other;     // open, where the world is not; null when there is none yet
	bool alone;         // there is no other device
	bool trial;         // the world is where it is to be measured
	Meter meters[2];    // of the CPU, and of the other
	double current;     // ms that the library has worked since the last step began
	double spent;       // ms of steps since the last comparison
	double begun;       // ms, when the last trial began
	double cost;        // ms that the last trial took, with its steps; 0 before the first
	int failures;       // trials in a row after which the world went back
	int failures_work;  // bodies and contacts at the last of them
} AutoDevice;

// Device "auto" from now on; and no longer.
void auto_open(scree_world* world);
void auto_close(scree_world* world);

// Called before a step: counts the last one, and moves the world when that pays. Fails only when the world breaks.
scree_status auto_choose(scree_world* world);

// Milliseconds on the clock; and adds what has passed since then to the step at work.
double auto_clock(void);
void auto_count(scree_world* world, double since);

#endif
