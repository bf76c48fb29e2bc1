// SPDX-License-Identifier: MIT
// migrate.h -- moves a world from one device to another, between two steps.
#ifndef MIGRATE_H
#define MIGRATE_H
#include "backend/backend.h"

// Copies the pools to another device, which may have contained a world, and sets world->backend to it. The old device
// stays open, and belongs to the caller. On failure the world stays there, and breaks only if the old device has
// failed.
scree_status world_move(scree_world* world, Backend* to);

#endif
