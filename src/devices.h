// SPDX-License-Identifier: MIT
// devices.h -- the device that a world runs on.
#ifndef DEVICES_H
#define DEVICES_H
#include "backend.h"
#include "check.h"

// One of the forms of scree_world_def.device?
scree_status check_device(Where at, const char* member, const char* device);

// Opens the device of a definition; "auto" means the CPU here.
scree_status device_open(const scree_world_def* def, Backend** backend);

// Opens a GPU that says that it keeps equal bits, if there is one.
scree_status device_open_gpu(const scree_world_def* def, Backend** backend);

#endif
