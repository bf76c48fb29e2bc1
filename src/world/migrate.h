// SPDX-License-Identifier: MIT
// migrate.h -- a world from one device to another, between two steps.
#ifndef MOVE_H
#define MOVE_H
#include "backend/backend.h"

// Copies all that world->backend holds to another device, which may have held a world before, and makes that one
// world->backend. The old one stays open and is the caller's. On failure the world is where it was; it is broken only
// if the device that it was on has failed.
scree_status world_move(scree_world* world, Backend* to);

#endif
