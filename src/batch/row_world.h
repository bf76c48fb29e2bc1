// SPDX-License-Identifier: MIT
// row_world.h -- moves states between rows and ordinary worlds.
#ifndef ROW_WORLD_H
#define ROW_WORLD_H
#include "batch/world_row.h"

// Makes a row of the state of a world that was read, with the fingerprint of the template whose structure it has. targets: its
// pending targets, as a set of those of this template. target_hash: targets_hash of this set. The caller releases *row. Sets
// *bytes to its size.
scree_status row_of_world(const Template* read, uint64_t targets, uint64_t target_hash, const char* function,
                          char** row, size_t* bytes);

// Puts a world, which was restored from the snapshot of a template, into the state of a row, which was checked. row:
// begins memory of scree_allocate, so that its items are aligned.
scree_status world_take_row(scree_world* world, const char* function, const Template* from, const char* row);

#endif
