// SPDX-License-Identifier: MIT
// snapshot.h -- writes a world as a snapshot, and restores it on any device.
#ifndef SNAPSHOT_H
#define SNAPSHOT_H
#include "backend/backend.h"
#include "world/snapshot/chunks.h"

// Writes a snapshot of a world. function: caller, for messages.
scree_status snapshot_write(scree_world* world, const char* function, ChunkWriter* writer);

// Replaces the content of a world by a snapshot. A snapshot that is refused, or lack of memory, changes nothing. If the
// device fails, the world is broken.
scree_status snapshot_restore(scree_world* world, const char* function, const void* bytes, size_t size);

#endif
