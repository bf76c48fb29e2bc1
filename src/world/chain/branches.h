// SPDX-License-Identifier: MIT
// branches.h -- finds branches: trees of joints, solved together, around light bodies that carry heavy bodies.
#ifndef BRANCHES_H
#define BRANCHES_H
#include "world/chain/chain_search.h"

size_t branches_bytes(size_t joints, size_t bodies);

// Finds all branches. Must be called before the search for chains. memory: branches_bytes() bytes that are zero,
// aligned for pointers; afterwards s->layout points into this memory.
void branches_find(ChainSearch* s, void* memory);

#endif
