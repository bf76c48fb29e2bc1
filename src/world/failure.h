// SPDX-License-Identifier: MIT
// failure.h -- the sticky error of a world, after which it can only be destroyed.
#ifndef FAILURE_H
#define FAILURE_H
#include "scree/scree.h"

// Refuses a world that is null or broken.
scree_status world_check(const scree_world* world, const char* function);

// Returns the given status. SCREE_ERROR_DEVICE_FAILED breaks the world.
scree_status world_note(scree_world* world, scree_status status);

#endif
