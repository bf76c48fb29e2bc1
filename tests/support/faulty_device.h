// SPDX-License-Identifier: MIT
// faulty_device.h -- turns a CPU into a device without shared memory, and lets its calls fail as a test requests.
#ifndef FAULTY_DEVICE_H
#define FAULTY_DEVICE_H
#include "backend/backend.h"
#include "support/checks.h"

typedef enum // groups of device calls that can be made to fail
{
	FAULT_RESIZE = 1,
	FAULT_COPY = 2, // write, read
	FAULT_WORK = 4, // run, solve, read_begin, read_end, wait, timings
} FaultyCalls;

typedef struct
{
	unsigned calls;      // bits of FaultyCalls: calls that may fail
	int calls_left;      // number of these calls that succeed before a failure; negative: no call fails
	bool lasts;          // true: all later calls fail too; false: only one call fails
	scree_status status; // status that a failing call returns
} Fault;

extern Fault device_fault;
extern const BackendFunctions* real_functions; // functions of the CPU last passed to a function below

// Return functions of a CPU that does not give access to its memory by address. Functions from faulty_functions also
// fail as set in device_fault.
BackendFunctions distant_functions(Backend* cpu);
BackendFunctions faulty_functions(Backend* cpu);

#endif
