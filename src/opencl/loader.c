// SPDX-License-Identifier: MIT
// loader.c -- opens the OpenCL library and finds its functions.
#include "opencl/loader.h"
#include "platform/error.h"
#include <stdatomic.h>
#include <stdlib.h>

OpenClFunctions opencl;
static void* opened; // handle of the OpenCL library

#ifdef _WIN32
#include <windows.h>
static const char* const library_names[] = {"OpenCL.dll"};
static void describe_machine(void) {}
static void* open_named(const char* name) { return (void*)LoadLibraryA(name); }
static void* find(void* library, const char* name) { return (void*)GetProcAddress((HMODULE)library, name); }
#else
#include <dlfcn.h>
#ifdef __linux__
#include <stdio.h>
#include <unistd.h>

// Sets the environment variable HWLOC_SYNTHETIC, unless it is set, to the memory size and number of processors that
// sysconf returns. PoCL reads them through hwloc. Without sysfs, as in some containers, hwloc would find no memory, and
// PoCL would end the process; with sysfs, the function changes nothing.
static void describe_machine(void)
{
	char text[96];
	if (access("/sys/devices/system/cpu", F_OK) == 0)
		return;
	snprintf(text, sizeof text, "numa:1(memory=%lld) pu:%ld",
	         (long long)sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGESIZE), sysconf(_SC_NPROCESSORS_ONLN));
	setenv("HWLOC_SYNTHETIC", text, 0);
}
#else
static void describe_machine(void) {}
#endif

static const char* const library_names[] = {
#ifdef __APPLE__
    "/System/Library/Frameworks/OpenCL.framework/OpenCL",
#else
    "libOpenCL.so.1",
    "libOpenCL.so",
#endif
};
static void* open_named(const char* name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL); }
static void* find(void* library, const char* name) { return dlsym(library, name); }
#endif

// Opens the library that the environment variable SCREE_OPENCL names, or that of the system.
static void* open_library(void)
{
	const char* chosen = getenv("SCREE_OPENCL");
	void* library = NULL;
	describe_machine();
	if (chosen && *chosen)
	{
		library = open_named(chosen);
		if (!library)
			log_sentence(SCREE_LOG_WARNING, "SCREE_OPENCL is \"%s\", which cannot be opened; there is no OpenCL.",
			             chosen);
		return library;
	}
	for (size_t i = 0; i < sizeof library_names / sizeof *library_names && !library; ++i)
		library = open_named(library_names[i]);
	return library;
}

static bool fill_table(void)
{
	void* library = opened = open_library();
	if (!library)
		return false;
#define X(name)                                                                                                 \
	opencl.name = (__typeof__(opencl.name))find(library, "cl" #name);                                           \
	if (!opencl.name)                                                                                           \
	{                                                                                                           \
		log_sentence(SCREE_LOG_WARNING, "The OpenCL library has no cl" #name ": it is older than OpenCL 1.2."); \
		return false;                                                                                           \
	}
	OPENCL_FUNCTIONS(X)
#undef X
	return true;
}

bool opencl_load(void)
{
	enum
	{
		UNTRIED,
		OPENING,
		MISSING,
		LOADED
	};
	static atomic_int state = UNTRIED;
	int seen = UNTRIED;
	if (atomic_compare_exchange_strong(&state, &seen, OPENING))
		atomic_store(&state, fill_table() ? LOADED : MISSING);
	while ((seen = atomic_load(&state)) == OPENING)
		; // another thread is opening the library
	return seen == LOADED;
}

void* opencl_find(cl_platform_id platform, const char* name)
{
	void* function = opencl.GetExtensionFunctionAddressForPlatform(platform, name);
	return function ? function : find(opened, name);
}

const char* opencl_error_name(cl_int code)
{
#define X(name) \
	case name:  \
		return #name;
	switch (code)
	{
		X(CL_DEVICE_NOT_FOUND)
		X(CL_DEVICE_NOT_AVAILABLE)
		X(CL_COMPILER_NOT_AVAILABLE)
		X(CL_MEM_OBJECT_ALLOCATION_FAILURE)
		X(CL_OUT_OF_RESOURCES)
		X(CL_OUT_OF_HOST_MEMORY)
		X(CL_PROFILING_INFO_NOT_AVAILABLE)
		X(CL_BUILD_PROGRAM_FAILURE)
		X(CL_INVALID_VALUE)
		X(CL_INVALID_DEVICE)
		X(CL_INVALID_CONTEXT)
		X(CL_INVALID_QUEUE_PROPERTIES)
		X(CL_INVALID_COMMAND_QUEUE)
		X(CL_INVALID_MEM_OBJECT)
		X(CL_INVALID_BINARY)
		X(CL_INVALID_BUILD_OPTIONS)
		X(CL_INVALID_PROGRAM)
		X(CL_INVALID_PROGRAM_EXECUTABLE)
		X(CL_INVALID_KERNEL_NAME)
		X(CL_INVALID_KERNEL)
		X(CL_INVALID_ARG_INDEX)
		X(CL_INVALID_ARG_VALUE)
		X(CL_INVALID_ARG_SIZE)
		X(CL_INVALID_KERNEL_ARGS)
		X(CL_INVALID_WORK_GROUP_SIZE)
		X(CL_INVALID_WORK_ITEM_SIZE)
		X(CL_INVALID_EVENT)
		X(CL_INVALID_OPERATION)
		X(CL_INVALID_BUFFER_SIZE)
		X(CL_INVALID_GLOBAL_WORK_SIZE)
		X(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST)
	}
#undef X
	return code == NO_ANSWER ? "no answer in time"
	       : code == -1001   ? "CL_PLATFORM_NOT_FOUND_KHR"
	       : code == -9999   ? "bad memory access (NVIDIA)"
	                         : "unknown error";
}
