// SPDX-License-Identifier: MIT
// restore.h -- restores a world from a snapshot, on any device.
#ifndef RESTORE_H
#define RESTORE_H
#include "scree/scree.h"

// Replaces the content of a world by a snapshot. A snapshot that is refused, or lack of memory, changes nothing. If the
// device fails, the world is broken.
scree_status snapshot_restore(scree_world* world, const char* function, const void* bytes, size_t size);

#endif
