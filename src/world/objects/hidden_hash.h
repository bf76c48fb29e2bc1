// SPDX-License-Identifier: MIT
// hidden_hash.h -- computes the part of the hash of a world that only the host has.
#ifndef HIDDEN_HASH_H
#define HIDDEN_HASH_H
#include "scree/scree.h"

uint64_t world_hidden_hash(const scree_world* world);

// Return the parts of it that a pending target of a kinematic body adds, and the visits to sensors at the end of the last
// step.
uint64_t target_hash(int body, scree_pose pose);
uint64_t world_visits_hash(const scree_world* world);

#endif
