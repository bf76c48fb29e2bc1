// SPDX-License-Identifier: MIT
// faulty_device.h -- a CPU that works as if it were distant, and whose calls fail when a test says so.
#ifndef FAULTY_DEVICE_H
#define FAULTY_DEVICE_H
#include "backend/backend.h"
#include "support/checks.h"

typedef enum // calls that may fail
{
	FAULT_RESIZE = 1,
	FAULT_COPY = 2, // write, read
	FAULT_WORK = 4, // run, solve, read_begin, read_end, wait, timings
} FaultyCalls;

typedef struct
{
	unsigned calls;      // bits of FaultyCalls
	int calls_left;      // number of these that succeed before one fails; negative: none fails
	bool lasts;          // all calls after it fail too
	scree_status status; // result of a call that fails
} Fault;

extern Fault device_fault;
extern const BackendFunctions* real_functions; // those of the last CPU that was given others

// The functions of a CPU, but that its memory cannot be reached by address; those of faulty_functions fail as device_fault says.
BackendFunctions distant_functions(Backend* cpu);
BackendFunctions faulty_functions(Backend* cpu);

#endif
