// SPDX-License-Identifier: MIT
// faulty_device.h -- a CPU that behaves like a distant device, and whose calls fail on request of a test.
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
	bool lasts;          // all later calls fail too
	scree_status status; // result of a call that fails
} Fault;

extern Fault device_fault;
extern const BackendFunctions* real_functions; // functions of the last CPU whose functions were replaced

// Return functions of a CPU whose memory cannot be accessed by address. Those of faulty_functions fail as set by
// device_fault.
BackendFunctions distant_functions(Backend* cpu);
BackendFunctions faulty_functions(Backend* cpu);

#endif
