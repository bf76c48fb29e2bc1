// SPDX-License-Identifier: MIT
// branches.h -- finds branches: trees of joints around light bodies that carry heavy ones, which are solved together.
#ifndef BRANCHES_H
#define BRANCHES_H
#include "world/chain/chain_search.h"

// Returns the bytes of memory that branches_find needs for the given numbers of joints and bodies.
size_t branches_bytes(size_t joints, size_t bodies);

// Finds all branches, before the chains are found. memory is zero and aligned to pointers; the layout keeps parts of
// it.
void branches_find(ChainSearch* s, void* memory);

#endif
