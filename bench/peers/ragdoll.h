// SPDX-License-Identifier: MIT
// ragdoll.h -- adds a ragdoll of 11 bodies to a scene made by code.
#ifndef RAGDOLL_H
#define RAGDOLL_H
#include "fixture.h"

// Adds a ragdoll that stands at a place (m). group, 1 or more: body parts with the same group do not touch each other.
// user: user data of its bodies.
void ragdoll_add(FixtureBuild* build, scree_vec at, int group, uint64_t user);

#endif
