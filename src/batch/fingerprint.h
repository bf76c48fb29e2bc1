// SPDX-License-Identifier: MIT
// fingerprint.h -- computes the hash of what neither steps nor inputs change: the structure of a world, and its settings.
#ifndef FINGERPRINT_H
#define FINGERPRINT_H
#include "batch/template.h"

// Returns the hash of a world that was read. Values that inputs may set (own_values.h, motor speeds) are no part of it.
uint64_t fingerprint_of(const Template* from, const scree_world* world);

#endif
