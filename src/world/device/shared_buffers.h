// SPDX-License-Identifier: MIT
// shared_buffers.h -- memory of the device that a world shares with other programs.
#ifndef SHARED_BUFFERS_H
#define SHARED_BUFFERS_H
#include "backend/backend.h"
#include "scree/scree.h"

#define SHARED_LEAST 32 // minimum bytes: one row, query or answer

// Shares memory with other programs for a use. what, for messages: "rows" or "queries".
scree_status world_share(scree_world* world, const char* function, const char* what, SharedUse use,
                         const SharedMemory* memory);

// Ends the sharing of memory. Does nothing if none is shared.
void world_unshare(scree_world* world);

#endif
