// SPDX-License-Identifier: MIT
// own_chains.h -- keeps the chains of worlds of a block whose masses or disabled joints differ from those of the template.
#ifndef OWN_CHAINS_H
#define OWN_CHAINS_H
#include "world/chain/chain_search.h"

typedef struct // chains that some worlds of a block have
{
	ChainSearch search;
	char* memory;
	int uses; // number of these worlds
} OwnChains;

typedef struct
{
	OwnChains** known; // in no order
	int count, capacity;
} ChainList;

void own_chains_close(ChainList* list);

// Finds the chains of a world. Sets *found to an entry of the list, with one more use; to null if they are those of the
// template.
scree_status own_chains_find(ChainList* list, const scree_world* world, const ChainSearch* template, OwnChains** found);

// Removes a use. chains: may be null.
void own_chains_leave(ChainList* list, OwnChains* chains);

// Adds `bit` to the entries of joints that are in a chain or branch.
void own_chains_mark(const ChainSearch* search, uint8_t* joints, uint8_t bit);

#endif
