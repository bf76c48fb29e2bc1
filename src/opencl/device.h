// SPDX-License-Identifier: MIT
// device.h -- lists the OpenCL devices of this machine, with what is known about their bits.
#ifndef OPENCL_DEVICE_H
#define OPENCL_DEVICE_H
#include "backend/backend.h"
#include "opencl/loader.h"
#include "opencl/verdict.h"

typedef struct
{
	cl_platform_id platform;
	cl_device_id id;
	cl_device_type type;
	bool correct_division;             // supports -cl-fp32-correctly-rounded-divide-sqrt
	bool own_rounding;                 // true: quotients and roots are rounded by dialect/own_rounding.h
	bool shares_opengl, shares_memory; // has cl_khr_gl_sharing; imports memory by file descriptor
	bool compiles_at_launch;    // true for PoCL, which has its own cache: programs are not stored in that of cache.c
	size_t local_memory;        // bytes per work-group
	cl_int error;               // code of the first query of the device that failed; CL_SUCCESS: none
	const char* error_function; // name of the function that returned `error`
	bool usable;                // false: Scree cannot use the device with any option; about.reason states the reason
	Digest verdict_key;         // key of the verdict on the device (verdict.h)
	char name[104];             // as its driver gives it; equal devices have the same
	int number;                 // 1 for the first device with this name, 2 for the next
	char platform_name[128];
	char identity[768]; // platform, device and driver with all versions; part of the key of the program cache
	scree_device about; // the entry that scree_devices_get returns
} Device;

#define MAX_DEVICES 64

// Writes at most `capacity` devices. Returns the total number of devices.
int device_list(Device* devices, int capacity);

// Returns the reason why the last list of devices was empty, or "". count: number of devices in it.
const char* device_hint(int count);

// Returns whether a device without a verdict is tested with own rounding: it does not report correct rounding, or a
// test has chosen own rounding.
bool device_own_rounding(const Device* device);

// s: Returns the limit of a wait for a command of the device, or INFINITY (scree_world_def.device_timeout).
double device_wait_limit(const Device* device, const BackendOptions* options);

// Sets the members of a device that follow from the verdict on it.
void device_judge(Device* device, const Verdict* verdict);

#endif
