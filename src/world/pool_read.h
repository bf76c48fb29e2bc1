// SPDX-License-Identifier: MIT
// pool_read.h -- reads pools from the device.
#ifndef POOL_READ_H
#define POOL_READ_H
#include "backend/backend.h"

// Reads items of a pool for the user. For device "auto", adds the time of the read to that of the current step.
scree_status world_read(scree_world* world, PoolId pool, int first, int count, void* items);

// Reads for `count` bodies whether they sleep: 1 or 0. A body that a pending call of the user wakes does not sleep.
scree_status world_read_sleep(scree_world* world, int first, int count, int* asleep);

// Returns the pose of a body's origin. row: the body's row in the pool pose, which is the pose of its center of mass.
scree_pose world_body_pose(const scree_world* world, int index, const Float4* row);

#endif
