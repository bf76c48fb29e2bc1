// SPDX-License-Identifier: MIT
// auto_state.h -- declares the state of a world for device "auto".
#ifndef AUTO_STATE_H
#define AUTO_STATE_H
#include "backend/backend.h"

#define RECENT_STEPS 7

typedef struct AsyncOpen AsyncOpen;

typedef struct // measured times of steps on one device
{
	double recent[RECENT_STEPS]; // ms of the last steps, in arbitrary order
	int count;                   // number of steps since the world moved to this device
	double step;                 // ms per step when the devices were last compared; 0 before the first trial
	int work;                    // number of bodies and contacts when `step` was measured
} StepMeter;

typedef struct
{
	bool on;             // true if "auto" was given as the device
	char named[160];     // value of SCREE_AUTO: GPU to try at once; "cpu": none; empty: any, when it may pay
	TestWorlds* test;    // test of a GPU without a verdict
	AsyncOpen* opening;  // the other device while a thread opens it, or null
	Backend* other;      // the other device, open but without the world; null until it is open
	bool alone;          // true: the world stays on its device
	bool trial;          // true: the world is on the other device for a trial, and moves back if that is slower
	StepMeter meters[2]; // [0]: steps on the CPU; [1]: steps on the GPU
	double current;      // ms for which the library has worked since the last step began
	double spent;        // ms for which the library has worked since the last trial ended
	double started;      // ms: time at which the latest trial began
	double cost;         // ms that the last trial took, including its steps; 0 before the first trial
	int failures;        // number of consecutive trials that ended with a move back
	int failures_work;   // number of bodies and contacts at the end of the last trial
} AutoDevice;

#endif
