// SPDX-License-Identifier: MIT
// chains.h -- finds chains: joints in a row, which are solved together.
#ifndef CHAINS_H
#define CHAINS_H
#include "world/chain/chain_search.h"
#include "world/world.h"

// Finds the chains and branches of a world, and allocates *memory, which the caller frees, for them: ChainLayout without
// the results of chain_layout.
scree_status chains_find(const scree_world* world, ChainSearch* search, char** memory);

// Uploads the results of chain_layout.
scree_status chains_upload(Pipeline* pipeline, const ChainLayout* layout);

// Finds and uploads chains and branches again if joints or masses changed. Marks joints with new spots as pending.
scree_status chains_update(scree_world* world);

#endif
