// SPDX-License-Identifier: MIT
// bounds.h -- a box around most points: a few that are far away do not count.
#ifndef BOUNDS_H
#define BOUNDS_H
#include "scree/scree.h"

// Finds a box around the points, larger by reach at each side, without those that are further from the middle half than five times
// its size in x or in y. False without points, or when memory is short.
bool bounds_find(const scree_vec* points, int count, float reach, scree_box* box);

// The box around two boxes.
scree_box bounds_join(scree_box a, scree_box b);

// The part of a box that is within so many sizes of another one, at each of its sides.
scree_box bounds_limit(scree_box box, scree_box around, float sizes);

#endif
