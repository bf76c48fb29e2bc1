// SPDX-License-Identifier: MIT
// saved_pools.h -- copies items of pools to the pool `saved` and back, without the bus.
#ifndef SAVED_POOLS_H
#define SAVED_POOLS_H
#include "world/world.h"

// Sets the number of items of each pool that a save contains: of the structure, or of the data that steps change, which
// include the leaves of trees. Returns the number of items of the pool `saved` for them.
int64_t saved_pools_count(const scree_world* world, bool structure, int counts[POOL_COUNT]);

// Copies the items of a range, or back.
scree_status saved_pools_copy(scree_world* world, bool structure, SavedRange range, const int counts[POOL_COUNT],
                              const int leaves[2], bool back);

// Enlarges the pools of a world for saved items.
scree_status saved_pools_reserve(scree_world* world, const int counts[POOL_COUNT]);

#endif
