// SPDX-License-Identifier: MIT
// hidden_hash.h -- computes the part of the hash of a world that only the host has.
#ifndef HIDDEN_HASH_H
#define HIDDEN_HASH_H
#include "scree/scree.h"

uint64_t world_hidden_hash(const scree_world* world);

#endif
