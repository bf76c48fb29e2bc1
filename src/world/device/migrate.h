// SPDX-License-Identifier: MIT
// migrate.h -- moves a world from one device to another, between two steps.
#ifndef MIGRATE_H
#define MIGRATE_H
#include "backend/backend.h"

// Copies the pools to another device, and sets world->backend to it. The new device may have contained a world before.
// The old device stays open and belongs to the caller. On failure the world stays on the old device, and is broken only
// if the old device has failed.
scree_status world_move(scree_world* world, Backend* to);

#endif
