// SPDX-License-Identifier: MIT
// context_failure.h -- calls OpenCL functions with objects of a context until the context fails.
#ifndef CONTEXT_FAILURE_H
#define CONTEXT_FAILURE_H
#include "opencl/loader.h"
#include <stdatomic.h>

// Error code after which calls with objects of a context may hang or crash; 0: none. Users of the context share it.
typedef atomic_int ContextFailure;

// Calls an OpenCL function and returns its error code. After the failure of its context the function is not called, and
// the code is that of the failure. failure: that of the context of the arguments.
#define CODE(failure, name, ...) (context_failed(failure) ? context_error(failure) : opencl.name(__VA_ARGS__))

// The same, and checks the code.
#define CALL(failure, name, ...) context_check((failure), "cl" #name, CODE(failure, name, __VA_ARGS__))

// Calls an OpenCL function that returns a new object and writes an error code to its last argument. Writes the object,
// or null, and the code to the variables `object` and `error`.
#define CREATE(failure, object, error, name, ...)                               \
	do                                                                          \
	{                                                                           \
		(error) = context_error(failure);                                       \
		(object) = (error) ? NULL : opencl.Create##name(__VA_ARGS__, &(error)); \
		if (error)                                                              \
			(object) = NULL;                                                    \
	} while (0)

// Releases an object unless it is null or its context has failed; then it is abandoned. Keeps the last error message.
#define RELEASE(failure, name, object)                                                    \
	do                                                                                    \
	{                                                                                     \
		if ((object) && !context_failed(failure))                                         \
			context_released((failure), "clRelease" #name, opencl.Release##name(object)); \
	} while (0)

static inline bool context_failed(const ContextFailure* failure)
{
	return atomic_load_explicit(failure, memory_order_relaxed) != 0;
}

static inline cl_int context_error(const ContextFailure* failure) { return (cl_int)atomic_load(failure); }

// Returns SCREE_OK for CL_SUCCESS; otherwise fails with a message such as "clName: CL_OUT_OF_RESOURCES (-5)", and marks
// the context as failed unless the code states that the call alone failed.
scree_status context_check(ContextFailure* failure, const char* function, cl_int code);

// Marks the context as failed if the code demands it. Returns whether the context has failed, now or before.
bool context_note(ContextFailure* failure, cl_int code);

// Logs the error code of a call that releases an object, unless it is CL_SUCCESS.
void context_released(ContextFailure* failure, const char* function, cl_int code);

// Returns once a command has ended; the caller has flushed its queue. limit: s, or INFINITY, with which it calls
// clWaitForEvents. cpu: the thread sleeps at once, because the device needs the core. Fails and marks the context as
// failed if the command fails or does not end in time; the command may then still write to its memory.
scree_status wait_for(ContextFailure* failure, cl_event event, double limit, bool cpu);

#endif
