// SPDX-License-Identifier: MIT
// color_check.h -- checks the colors of constraints that come from bytes of a user.
#ifndef COLOR_CHECK_H
#define COLOR_CHECK_H
#include "world/snapshot/item_check.h"

// Fails with SCREE_ERROR_INVALID if a color is out of range, if a constraint has a color and sleeps, if a pool has another
// number of constraints of a body than there are, or if it has colors that none of them has: the coloring would find no
// free color. The bodies of the constraints are checked. index, pools: as in item_check.h.
scree_status color_check(const ChunkIndex* index, const ItemCounts* counts, void* const* pools);

#endif
