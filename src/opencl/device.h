// SPDX-License-Identifier: MIT
// device.h -- the OpenCL devices of this machine, and whether each can keep the promise of equal bits.
#ifndef OPENCL_DEVICE_H
#define OPENCL_DEVICE_H
#include "backend/backend.h"
#include "opencl/loader.h"

typedef struct
{
	cl_platform_id platform;
	cl_device_id id;
	cl_device_type type;
	bool correct_division;             // takes -cl-fp32-correctly-rounded-divide-sqrt
	bool shares_opengl, shares_memory; // has cl_khr_gl_sharing; takes memory by file descriptor
	bool usable;                       // false when no option can make Scree run on it; about.reason says why
	char platform_name[128];
	char identity[768]; // platform, device and driver with all versions: part of the key of the program cache
	scree_device about; // what scree_devices_get tells
} Device;

// Writes at most capacity devices, and returns how many there are.
int device_list(Device* devices, int capacity);

// The best device for a world: one whose own or platform's name has the given part, upper or lower case, when there is
// one; those that keep equal bits before others, GPUs before others. Fails with SCREE_ERROR_NO_DEVICE.
scree_status device_choose(const BackendOptions* options, Device* device);

#endif
