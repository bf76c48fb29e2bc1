// SPDX-License-Identifier: MIT
// loader.h -- opens OpenCL at run time, so that Scree builds and runs on the CPU without OpenCL.
#ifndef OPENCL_LOADER_H
#define OPENCL_LOADER_H
#include "scree/scree.h"
#include <stdbool.h>

#define CL_TARGET_OPENCL_VERSION 120
#ifdef __APPLE__
#include <OpenCL/opencl.h>
#else
#include <CL/cl.h>
#endif

// functions that Scree calls, named without the prefix "cl"
#define OPENCL_FUNCTIONS(X)                   \
	X(GetPlatformIDs)                         \
	X(GetPlatformInfo)                        \
	X(GetDeviceIDs)                           \
	X(GetDeviceInfo)                          \
	X(GetExtensionFunctionAddressForPlatform) \
	X(CreateContext)                          \
	X(ReleaseContext)                         \
	X(CreateCommandQueue)                     \
	X(ReleaseCommandQueue)                    \
	X(CreateProgramWithSource)                \
	X(CreateProgramWithBinary)                \
	X(BuildProgram)                           \
	X(GetProgramInfo)                         \
	X(GetProgramBuildInfo)                    \
	X(ReleaseProgram)                         \
	X(CreateKernel)                           \
	X(SetKernelArg)                           \
	X(GetKernelWorkGroupInfo)                 \
	X(ReleaseKernel)                          \
	X(CreateBuffer)                           \
	X(ReleaseMemObject)                       \
	X(EnqueueNDRangeKernel)                   \
	X(EnqueueReadBuffer)                      \
	X(EnqueueMapBuffer)                       \
	X(EnqueueUnmapMemObject)                  \
	X(WaitForEvents)                          \
	X(EnqueueWriteBuffer)                     \
	X(EnqueueCopyBuffer)                      \
	X(EnqueueFillBuffer)                      \
	X(EnqueueBarrierWithWaitList)             \
	X(GetEventInfo)                           \
	X(GetEventProfilingInfo)                  \
	X(ReleaseEvent)                           \
	X(Flush)                                  \
	X(Finish)

typedef struct
{
#define X(name) __typeof__(cl##name)* name;
	OPENCL_FUNCTIONS(X)
#undef X
} OpenClFunctions;
extern OpenClFunctions opencl; // filled by opencl_load

// Code of a command that did not end within the limit of wait_for (context_failure.h); OpenCL has no code for it.
#define NO_ANSWER (-9998)

// Opens the library, once per process, from any thread. Returns false if it does not exist or lacks a function.
bool opencl_load(void);

// Returns a function of an extension or of a newer OpenCL version by its full name, or null if it does not exist.
void* opencl_find(cl_platform_id platform, const char* name);

// Returns the name of an error code, such as "CL_OUT_OF_RESOURCES", or "unknown error".
const char* opencl_error_name(cl_int code);

#endif
