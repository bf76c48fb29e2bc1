// SPDX-License-Identifier: MIT
// host_check.h -- checks the data of a restored world on the host: indices, lists and numbers of users of each object.
#ifndef HOST_CHECK_H
#define HOST_CHECK_H
#include "world/snapshot/columns.h"

// Fails with SCREE_ERROR_INVALID if some index is out of range, or if lists contradict each other, so that a later call
// could read or write beyond an array, or never end.
scree_status host_check(const ChunkIndex* index, const scree_world* world);

#endif
