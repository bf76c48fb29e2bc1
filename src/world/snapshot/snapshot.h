// SPDX-License-Identifier: MIT
// snapshot.h -- writes a world as a snapshot.
#ifndef SNAPSHOT_H
#define SNAPSHOT_H
#include "world/snapshot/chunks.h"

// Writes a snapshot of a world. function: caller, for messages.
scree_status snapshot_write(scree_world* world, const char* function, ChunkWriter* writer);

#endif
