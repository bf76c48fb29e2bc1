// SPDX-License-Identifier: MIT
// devices.h -- lists the devices, and opens one.
#ifndef DEVICES_H
#define DEVICES_H
#include "backend/backend.h"

// Lists up to capacity devices, the CPU first. Returns the total number of devices.
int devices_list(scree_device* devices, int capacity);

// Opens the device of a definition; "auto" stands for the CPU here.
scree_status device_open(const scree_world_def* def, Backend** backend);

// Opens the first GPU that reports arithmetic with equal bits, if there is one.
scree_status device_open_gpu(const scree_world_def* def, Backend** backend);

#endif
