// SPDX-License-Identifier: MIT
// device.h -- lists the OpenCL devices of this machine, and finds out whether each computes the same bits as the CPU.
#ifndef OPENCL_DEVICE_H
#define OPENCL_DEVICE_H
#include "backend/backend.h"
#include "opencl/loader.h"

typedef struct
{
	cl_platform_id platform;
	cl_device_id id;
	cl_device_type type;
	bool correct_division;             // supports -cl-fp32-correctly-rounded-divide-sqrt
	bool shares_opengl, shares_memory; // has cl_khr_gl_sharing; imports memory by file descriptor
	bool compiles_at_launch; // true for PoCL, which has its own cache: programs are not stored in that of cache.c
	size_t local_memory;     // bytes per work-group
	bool usable;             // false: Scree cannot use the device with any option; about.reason states the reason
	char platform_name[128];
	char identity[768]; // platform, device and driver with all versions; part of the key of the program cache
	scree_device about; // the entry that scree_devices_get returns
} Device;

// Writes at most `capacity` devices. Returns the total number of devices.
int device_list(Device* devices, int capacity);

// Chooses a device whose name or platform name contains options->device (case ignored). Prefers devices that the
// options allow, then GPUs, then devices with equal bits. Fails with SCREE_ERROR_NO_DEVICE if no device is found or the
// best is not allowed.
scree_status device_choose(const BackendOptions* options, Device* device);

#endif
