// SPDX-License-Identifier: MIT
// hidden_hash.h -- computes the part of the hash of a world that only the host has.
#ifndef HIDDEN_HASH_H
#define HIDDEN_HASH_H
#include "scree/scree.h"

uint64_t world_hidden_hash(const scree_world* world);

// Returns the part of it that a pending target of a kinematic body is.
uint64_t target_hash(int body, scree_pose pose);
// Returns the part of world_hidden_hash that the visits to sensors at the end of the last step add.
uint64_t world_visits_hash(const scree_world* world);

#endif
