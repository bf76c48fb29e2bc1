// SPDX-License-Identifier: MIT
// fault_layer.h -- declares a library between Scree and OpenCL that counts calls and lets one of them fail.
//
// The library exports the OpenCL functions that Scree calls. A test sets SCREE_OPENCL to its path, finds the variable
// `fault_layer` in it, and writes the fault of the next calls to it. Calls come from one thread at a time.
#ifndef FAULT_LAYER_H
#define FAULT_LAYER_H
#include "opencl/loader.h"

enum // indices of the functions, in the order of OPENCL_FUNCTIONS
{
#define X(name) LAYER_##name,
	OPENCL_FUNCTIONS(X)
#undef X
	    LAYER_FUNCTIONS
};

typedef enum
{
	LAYER_ERROR, // the call returns `code` and does nothing; releases release the object all the same
	LAYER_LOST,  // the same, and the context is lost: later calls with its objects are violations, and return `code`
	LAYER_HANGS, // the call succeeds; commands of its context never end from then on
	LAYER_FAILS, // the call succeeds; commands of its context end with `code` from then on
} LayerFault;

typedef struct
{
	// written by the test
	LayerFault fault;
	cl_int code;
	long calls_left; // number of calls that succeed before the fault; negative: no fault
	long fault_at;   // first value of calls_left
	int function;    // only calls of this function are counted in calls_left; -1: all but clGetEventInfo, whose number
	                 // depends on the speed of the device

	// written by the library
	long calls, calls_of[LAYER_FUNCTIONS];
	const char* failed;     // name of the function that failed, such as "clFinish"; null: none since the last fault
	long violations;        // calls with objects of a lost context, and calls that would block for ever
	const char* violation;  // function of the last violation
	long unknown;           // releases of objects that do not exist
	int contexts, programs; // numbers of objects that exist
	int others;             // number of all other objects, events included

	// marks all contexts that hang as lost
	void (*lose)(void);
	// releases all objects of lost contexts, as if their process had ended
	void (*forget)(void);
} FaultLayer;

// Return before and after a call; see layer_calls.c.
cl_int layer_before(int function, const void* object, bool blocks);
void layer_made(const void* object, const void* parent, int function);
void layer_gone(const void* object);
void layer_mapped(const void* buffer, cl_command_queue queue, void* memory); // memory: null after an unmap
cl_int layer_state(const void* object, cl_int state);
bool layer_is_lost(const void* object);
extern OpenClFunctions layer_real;
extern FaultLayer fault_layer;

#endif
