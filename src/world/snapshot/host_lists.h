// SPDX-License-Identifier: MIT
// host_lists.h -- writes and reads the arrays of a world on the host: objects, slots and lists.
#ifndef HOST_LISTS_H
#define HOST_LISTS_H
#include "world/snapshot/columns.h"

// Writes the data of a world on the host. All edits must be uploaded, and the events of the last step be read.
void host_write(ChunkWriter* writer, scree_world* world);

// Reads the data on the host into a new world without a device. Checks only numbers of items; see host_check.h.
scree_status host_read(const ChunkIndex* index, scree_world* world);

#endif
