// SPDX-License-Identifier: MIT
// failure.h -- records that a world is broken. A broken world can only be destroyed.
#ifndef FAILURE_H
#define FAILURE_H
#include "scree/scree.h"

// Fails if a world is null or broken.
scree_status world_check(const scree_world* world, const char* function);

// Returns the given status. Marks the world as broken if the status is SCREE_ERROR_DEVICE_FAILED.
scree_status world_note(scree_world* world, scree_status status);

#endif
