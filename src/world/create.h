// SPDX-License-Identifier: MIT
// create.h -- creates a world on an open device, and destroys it.
#ifndef CREATE_H
#define CREATE_H
#include "backend/backend.h"

// Creates a world on an open device. On failure *world is null and the caller keeps the device.
scree_status world_create(const scree_world_def* def, Backend* backend, scree_world** world);

// Releases everything and closes the device, unless world->backend is null.
void world_destroy(scree_world* world);

#endif
