// SPDX-License-Identifier: MIT
// branches.h -- finds branches: joints around light bodies that carry heavy ones, which the solver solves together.
#ifndef BRANCHES_H
#define BRANCHES_H
#include "world/chain/chain_search.h"

// Bytes of memory for branches_find, for so many joints and bodies.
size_t branches_bytes(size_t joints, size_t bodies);

// Finds all branches, before there are chains. memory is zero and aligned to pointers; the layout keeps parts of it.
void branches_find(ChainSearch* s, void* memory);

#endif
