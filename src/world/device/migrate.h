// SPDX-License-Identifier: MIT
// migrate.h -- moves a world from one device to another, between two steps.
#ifndef MIGRATE_H
#define MIGRATE_H
#include "backend/backend.h"

// Copies the pools to another device, which may have held a world before, and sets world->backend to it. The old device
// stays open and belongs to the caller. On failure the world stays there; it is broken only if that device has failed.
scree_status world_move(scree_world* world, Backend* to);

#endif
