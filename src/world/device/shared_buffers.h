// SPDX-License-Identifier: MIT
// shared_buffers.h -- lets a world share memory of its device with other programs.
#ifndef SHARED_BUFFERS_H
#define SHARED_BUFFERS_H
#include "backend/backend.h"
#include "scree/scree.h"

#define SHARED_LEAST 32 // bytes: minimum size of shared memory: one row, query or query result

// Begins to share memory with other programs. what: name of the use in messages, "rows" or "queries".
scree_status world_share(scree_world* world, const char* function, const char* what, SharedUse use,
                         const SharedMemory* memory);

// Ends the sharing of memory for all uses. Does nothing if no memory is shared.
void world_unshare(scree_world* world);

#endif
