// SPDX-License-Identifier: MIT
// color_check.h -- checks the colors of the constraints of a snapshot.
#ifndef COLOR_CHECK_H
#define COLOR_CHECK_H
#include "world/snapshot/columns.h"

// Fails with SCREE_ERROR_INVALID if a constraint has a color and sleeps, if a pool has another number of constraints of a body
// than there are, or if it has colors that none of them has: the coloring would find no free color. pools: as in pool_check,
// which has checked the indices.
scree_status color_check(const ChunkIndex* index, const scree_world* world, void* const* pools);

#endif
