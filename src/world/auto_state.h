// SPDX-License-Identifier: MIT
// auto_state.h -- the state of a world for device "auto".
#ifndef AUTO_STATE_H
#define AUTO_STATE_H
#include "backend/backend.h"

#define RECENT_STEPS 7

typedef struct AsyncOpen AsyncOpen;

// Compares the bits of an open device with those of the CPU. Fails if they differ.
typedef scree_status CompareDevice(Backend* backend);

typedef struct // measured times of steps on one device
{
	double recent[RECENT_STEPS]; // ms of the last steps, in no order
	int count;                   // steps since the world moved to this device
	double step;                 // ms per step at the last comparison; 0 before the first
	int work;                    // bodies and contacts at that comparison
} StepMeter;

typedef struct
{
	bool on;                // true if the device was given as "auto"
	char named[160];        // value of SCREE_AUTO: the device to try at once; empty: a GPU when it may pay
	CompareDevice* compare; // see async_open_begin
	AsyncOpen* opening;     // opening of the other device in progress, or null
	Backend* other;         // the other device, open but without the world; null before it is open
	bool alone;             // true: there is no other device
	bool trial;             // true: the world is on the device that is being measured
	StepMeter meters[2];    // for the CPU and for the other device
	double current;         // ms that the library has worked since the last step began
	double spent;           // ms of steps since the last comparison
	double started;         // ms: time at which the last trial began
	double cost;            // ms that the last trial took, including its steps; 0 before the first
	int failures;           // consecutive trials after which the world moved back
	int failures_work;      // bodies and contacts at the last such trial
} AutoDevice;

#endif
