// SPDX-License-Identifier: MIT
// shared_buffers.h -- memory of the device that a world shares with other programs.
#ifndef SHARED_BUFFERS_H
#define SHARED_BUFFERS_H
#include "backend/backend.h"
#include "scree/scree.h"

#define SHARED_LEAST 32 // bytes: a row, a query, an answer

// Takes memory for a use. what: rows or queries.
scree_status world_share(scree_world* world, const char* function, const char* what, SharedUse use,
                         const SharedMemory* memory);

// The device takes back the memory that it shares. Does nothing when it shares none.
void world_unshare(scree_world* world);

#endif
