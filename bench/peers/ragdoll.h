// SPDX-License-Identifier: MIT
// ragdoll.h -- a ragdoll of 11 bodies.
#ifndef RAGDOLL_H
#define RAGDOLL_H
#include "fixture.h"

// Adds a ragdoll that stands at a place. Parts of one group (1 or more) do not touch each other. user is the user data of its
// bodies.
void ragdoll_add(FixtureBuild* build, scree_vec at, int group, uint64_t user);

#endif
