// SPDX-License-Identifier: MIT
// lasting.h -- counts the items of pools that outlive a step, which moves and snapshots copy.
#ifndef LASTING_H
#define LASTING_H
#include "backend/tables.h"
#include "pools/pools.h"
#include "scree/scree.h"

// Returns the number of items of a kind that outlive a step. Slots beyond the capacity exist only in pending edits.
int lasting_items(const scree_world* world, Per per);

#endif
