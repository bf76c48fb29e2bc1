// SPDX-License-Identifier: MIT
// branches.h -- finds branches: trees of joints around light bodies that carry heavy ones, which are solved together.
#ifndef BRANCHES_H
#define BRANCHES_H
#include "world/chain/chain_search.h"

size_t branches_bytes(size_t joints, size_t bodies);

// Finds all branches, before chains. memory: branches_bytes, zero, aligned to pointers; the layout keeps parts of it.
void branches_find(ChainSearch* s, void* memory);

#endif
