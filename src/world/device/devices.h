// SPDX-License-Identifier: MIT
// devices.h -- lists the devices, opens a device, and tests a device.
#ifndef DEVICES_H
#define DEVICES_H
#include "backend/backend.h"

// Writes at most `capacity` devices to an array, the CPU first. Returns the total number of devices.
int devices_list(scree_device* devices, int capacity);

// Opens the device that a definition names. The name "auto" opens the CPU. An OpenCL device without a verdict is tested
// first, with `test`; it is refused if its bits differ from those of the CPU, unless the definition allows this.
scree_status device_open(const scree_world_def* def, TestWorlds* test, Backend** backend);

// The same, for the worlds of a batch. beside: the same device, open for other worlds of the batch, or null.
scree_status device_open_batch(const scree_world_def* def, TestWorlds* test, Backend* beside, Backend** backend);

// Opens the first GPU with the bits of the CPU, and tests it if there is no verdict on it. Fails if there is none.
scree_status device_open_gpu(const scree_world_def* def, TestWorlds* test, Backend** backend);

// Tests the OpenCL device with a name such as "opencl:NAME", and stores the verdict.
scree_status device_test(const char* device, TestWorlds* test);

#endif
