// SPDX-License-Identifier: MIT
// attribute_check.h -- checks definitions of attributes and surfaces.
#ifndef ATTRIBUTE_CHECK_H
#define ATTRIBUTE_CHECK_H
#include "world/check.h"

#define DEFAULT_FRICTION 0.6f

// Checks entry k of an array of definitions, and writes its canonical form: equal definitions then have equal bytes. at: place of
// the entry.
scree_status attribute_check(ArgumentPlace at, const scree_attribute_def* defs, int k, scree_attribute_def* plain);

// Checks the values of a surface, and writes them into a canonical definition, which stays canonical.
scree_status surface_check(ArgumentPlace at, const scree_surface* surface, scree_attribute_def* plain);

#endif
