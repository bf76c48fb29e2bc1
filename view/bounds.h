// SPDX-License-Identifier: MIT
// bounds.h -- finds a box around most points of a set, without outliers.
#ifndef BOUNDS_H
#define BOUNDS_H
#include "scree/scree.h"

// Finds a box around all points except outliers, and moves each side of the box outwards by `reach`, m. A point is an
// outlier if its distance from the middle half of all points is more than five times the size of that half, in x or in
// y. This size counts as at least 2 `reach` and 1/10 of the size in the other direction. Returns false if there are no
// points, or if memory is short.
bool bounds_find(const scree_vec* points, int count, float reach, scree_box* box);

// Returns the smallest box around two boxes.
scree_box bounds_join(scree_box a, scree_box b);

// Returns the part of `box` inside a larger box, which is `around` with each side moved outwards by `sizes` times the
// width (or height) of `around`.
scree_box bounds_limit(scree_box box, scree_box around, float sizes);

#endif
