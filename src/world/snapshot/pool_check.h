// SPDX-License-Identifier: MIT
// pool_check.h -- checks the pools of a snapshot before they are written to a device.
#ifndef POOL_CHECK_H
#define POOL_CHECK_H
#include "world/snapshot/columns.h"

// Fails with SCREE_ERROR_INVALID if a kernel could read or write beyond a pool. pools: items of each pool of the
// snapshot, by PoolId. The data on the host is already checked.
scree_status pool_check(const ChunkIndex* index, const scree_world* world, void* const* pools);

#endif
