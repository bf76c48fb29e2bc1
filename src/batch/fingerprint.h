// SPDX-License-Identifier: MIT
// fingerprint.h -- computes the hash of what no step of a world changes: its structure, and the settings of a step.
#ifndef FINGERPRINT_H
#define FINGERPRINT_H
#include "batch/template.h"

// Returns the hash. The image has the numbers of attributes of the world alone (before template_shift).
uint64_t fingerprint_of(const Template* from);

#endif
