// SPDX-License-Identifier: MIT
// hidden_hash.h -- computes the part of the hash of a world that only the host has.
#ifndef HIDDEN_HASH_H
#define HIDDEN_HASH_H
#include "scree/scree.h"

uint64_t world_hidden_hash(const scree_world* world);

// Returns the same without what may differ in the worlds of a batch: disabled bodies, masses that the user set, pending
// targets, and visits to sensors.
uint64_t hidden_hash_rest(const scree_world* world);

// Return what a disabled body, each of its collidables, a mass that the user set, and a pending target of a kinematic body
// add to the hash. The device does not hash disabled bodies, and has the mass of a body only while the body is dynamic.
uint64_t hidden_hash_disabled(const scree_world* world, int body);
uint64_t hidden_hash_collidable(const scree_world* world, int index, int attribute);
uint64_t hidden_hash_mass(int body, scree_mass mass);
uint64_t hidden_hash_target(int body, scree_pose pose);

#endif
