// SPDX-License-Identifier: MIT
// create.h -- creates a world on an open device, and destroys a world.
#ifndef CREATE_H
#define CREATE_H
#include "backend/backend.h"

// Creates a world on an open device. On failure sets *world to null, and the caller keeps the device.
scree_status world_create(const scree_world_def* def, Backend* backend, scree_world** world);

// Releases all memory of a world, and closes its device unless world->backend is null.
void world_destroy(scree_world* world);

#endif
