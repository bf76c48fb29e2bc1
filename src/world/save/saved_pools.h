// SPDX-License-Identifier: MIT
// saved_pools.h -- copies items of pools to the pool `saved` and back, without the bus.
#ifndef SAVED_POOLS_H
#define SAVED_POOLS_H
#include "world/world.h"

// Ranges begin at a multiple of this number of items of the pool `saved`, so that wide kernels can store MAX_LANES words.
#define ALIGNED (MAX_LANES * (int)sizeof(Word) / (int)sizeof(Float4))

// Sets the number of items of each pool that a save contains: of the structure, or of the data that steps change, which
// include the leaves of trees. Returns the number of items of the pool `saved` for them.
int64_t saved_pools_count(const scree_world* world, bool structure, int counts[POOL_COUNT]);

// Copies the items of a range, or back.
scree_status saved_pools_copy(scree_world* world, bool structure, SavedRange range, const int counts[POOL_COUNT],
                              const int leaves[2], bool back);

// Sets the places of the packed items of a save from item `first` of the pool `saved` on, apart from the room for the rest
// (src/stages/save/saved_words.h). Returns the number of words before the rest.
int64_t saved_words_count(const scree_world* world, int first, SavedLayout* layout);

// Packs the items of a save, or unpacks them after all copies of pools.
scree_status saved_words_run(const scree_world* world, const Save* save, bool back);

// Enlarges the pools of a world for saved items, and for the item more that scans have.
scree_status saved_pools_reserve(scree_world* world, const int counts[POOL_COUNT]);

#endif
