// SPDX-License-Identifier: MIT
// context_failure.c -- decides which errors are failures of a context, and waits for commands with a limit.
//
// After a failure such as CL_OUT_OF_RESOURCES of NVIDIA, any call with an object of the context may hang, even its
// release. So the first failure is stored for all users of the context, and its objects are abandoned.
#include "opencl/context_failure.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "platform/system.h"
#include <math.h>

// ms: first part of a wait, in which a thread reads the state of a command of a GPU without a pause, as blocking calls of
// NVIDIA do. A longer wait sleeps for a fraction of the time that has passed.
#define SPIN_MILLISECONDS 20.0
#define SLEEP_SHARE       (1.0 / 32)
#define SHORTEST_SLEEP    0.02 // ms
#define LONGEST_SLEEP     5.0  // ms

// Returns true for errors of a single call: lack of memory, programs that do not build, and refused arguments.
static bool is_harmless(cl_int code)
{
	switch (code)
	{
	case CL_SUCCESS:
	case CL_DEVICE_NOT_FOUND:
	case CL_COMPILER_NOT_AVAILABLE:
	case CL_MEM_OBJECT_ALLOCATION_FAILURE:
	case CL_OUT_OF_HOST_MEMORY:
	case CL_PROFILING_INFO_NOT_AVAILABLE:
	case CL_BUILD_PROGRAM_FAILURE:
	case CL_INVALID_VALUE:
	case CL_INVALID_BINARY:
	case CL_INVALID_BUILD_OPTIONS:
	case CL_INVALID_PROGRAM_EXECUTABLE:
	case CL_INVALID_KERNEL_NAME:
	case CL_INVALID_ARG_INDEX:
	case CL_INVALID_ARG_VALUE:
	case CL_INVALID_ARG_SIZE:
	case CL_INVALID_WORK_GROUP_SIZE:
	case CL_INVALID_WORK_ITEM_SIZE:
	case CL_INVALID_BUFFER_SIZE:
	case CL_INVALID_GLOBAL_WORK_SIZE:
		return true;
	}
	return false;
}

bool context_note(ContextFailure* failure, cl_int code)
{
	int none = 0;
	if (!is_harmless(code))
		atomic_compare_exchange_strong(failure, &none, (int)code);
	return context_failed(failure);
}

scree_status context_check(ContextFailure* failure, const char* function, cl_int code)
{
	if (code == CL_SUCCESS)
		return SCREE_OK;
	bool failed_before = context_failed(failure);
	context_note(failure, code);
	return fail(SCREE_ERROR_DEVICE_FAILED, "%s: %s (%d)%s", function, opencl_error_name(code), (int)code,
	            failed_before ? "; the context of this device has failed" : "");
}

void context_released(ContextFailure* failure, const char* function, cl_int code)
{
	if (code == CL_SUCCESS)
		return;
	context_note(failure, code);
	log_sentence(SCREE_LOG_WARNING, "%s: %s (%d)", function, opencl_error_name(code), (int)code);
}

static void rest(double passed, bool cpu)
{
	if (!cpu && passed < SPIN_MILLISECONDS)
	{
		give_core_away();
		return;
	}
	double pause = passed * SLEEP_SHARE;
	pause = pause > LONGEST_SLEEP ? LONGEST_SLEEP : pause;
	processor_sleep(pause > SHORTEST_SLEEP ? pause : SHORTEST_SLEEP);
}

scree_status wait_for(ContextFailure* failure, cl_event event, double limit, bool cpu)
{
	if (isinf(limit))
		return CALL(failure, WaitForEvents, 1, &event);
	cl_int state = CL_QUEUED;
	double begin = 0.0;
	for (;;)
	{
		TRY(CALL(failure, GetEventInfo, event, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof state, &state, NULL));
		if (state == CL_COMPLETE)
			return SCREE_OK;
		double now = processor_milliseconds();
		begin = begin > 0.0 ? begin : now;
		if (state < 0 || now - begin > 1e3 * limit)
			break;
		rest(now - begin, cpu);
	}
	// a command that failed or hangs makes its context useless, whatever its code
	int none = 0;
	atomic_compare_exchange_strong(failure, &none, state < 0 ? (int)state : NO_ANSWER);
	if (state < 0)
		return fail(SCREE_ERROR_DEVICE_FAILED, "clGetEventInfo: a command failed: %s (%d)", opencl_error_name(state),
		            (int)state);
	return fail(SCREE_ERROR_DEVICE_FAILED, "clGetEventInfo: a command has not ended within %g s; the device is lost",
	            limit);
}
