// SPDX-License-Identifier: MIT
// devices.h -- lists the devices, and opens a device.
#ifndef DEVICES_H
#define DEVICES_H
#include "backend/backend.h"

// Writes at most `capacity` devices to an array, the CPU first. Returns the total number of devices.
int devices_list(scree_device* devices, int capacity);

// Opens the device that a definition names. The name "auto" opens the CPU.
scree_status device_open(const scree_world_def* def, Backend** backend);

// Opens the first GPU whose reported arithmetic gives the same bits as the CPU. Fails if there is none.
scree_status device_open_gpu(const scree_world_def* def, Backend** backend);

#endif
