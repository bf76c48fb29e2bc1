// SPDX-License-Identifier: MIT
// auto_state.h -- what a world keeps for device "auto".
#ifndef AUTO_STATE_H
#define AUTO_STATE_H
#include "backend/backend.h"

#define RECENT_STEPS 7

typedef struct AsyncOpen AsyncOpen;

// Compares the bits of an open device with the CPU's; fails when they differ.
typedef scree_status CompareDevice(Backend* backend);

typedef struct // what a step costs on one device
{
	double recent[RECENT_STEPS]; // ms of the last steps, in no order
	int count;                   // steps since the world came to this device
	double step;                 // ms, as of the last comparison; 0 before the first
	int work;                    // bodies and contacts at that comparison
} StepMeter;

typedef struct
{
	bool on;                // the device was given as "auto"
	char named[160];        // by SCREE_AUTO: the device to try at once; empty for a GPU when it may pay
	CompareDevice* compare; // see async_open_begin
	AsyncOpen* opening;     // of the other device; null when none is being opened
	Backend* other;         // open, but the world is not on it; null when there is none yet
	bool alone;             // there is no other device
	bool trial;             // the world is on the device that is measured
	StepMeter meters[2];    // of the CPU, and of the other
	double current;         // ms that the library has worked since the last step began
	double spent;           // ms of steps since the last comparison
	double started;         // ms, when the last trial began
	double cost;            // ms that the last trial took, with its steps; 0 before the first
	int failures;           // trials in a row after which the world went back
	int failures_work;      // bodies and contacts at the last of them
} AutoDevice;

#endif
