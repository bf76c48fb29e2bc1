// SPDX-License-Identifier: MIT
// device.h -- lists the OpenCL devices of this machine, and finds out whether each computes equal bits.
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
	bool shares_opengl, shares_memory; // OpenGL: has cl_khr_gl_sharing; memory: imports file descriptors
	bool compiles_at_launch; // PoCL: binaries lack kernels for most sizes of launches; it has a separate cache
	bool usable;             // false: Scree cannot use the device with any option; about.reason states the reason
	char platform_name[128];
	char identity[768]; // platform, device and driver with all versions; part of the key of the program cache
	scree_device about; // the entry that scree_devices_get returns
} Device;

// Writes at most `capacity` devices. Returns the total number of devices.
int device_list(Device* devices, int capacity);

// Chooses a device whose name or platform name contains options->device (case ignored). Best are devices that the
// options allow, of these GPUs, and of these devices with equal bits. Fails with SCREE_ERROR_NO_DEVICE.
scree_status device_choose(const BackendOptions* options, Device* device);

#endif
