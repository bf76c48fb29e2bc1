// SPDX-License-Identifier: MIT
// room.h -- how much room the pools have.
#ifndef ROOM_H
#define ROOM_H
#include "step/state.h"

#define LEAST_ROOM 64 // items: a pool has a multiple of it

// Gives a kind of pool and those that follow it (constraints with contacts, leaves and nodes with collidables, ...)
// room for at least capacity items; grows by half at least.
scree_status pipeline_reserve(Pipeline* pipeline, Per per, int capacity);

// After a step: gives back the room of pools that have long been much too large.
void pipeline_trim(Pipeline* pipeline);

// Counts the step. Returns whether contacts have long been few for the slots that they are spread over.
bool pipeline_sparse(Pipeline* pipeline);

#endif
