// SPDX-License-Identifier: MIT
// materials.h -- keeps the surface values of pairs of materials, the rows of the pool material_pair.
#ifndef MATERIALS_H
#define MATERIALS_H
#include "world/world.h"

// Returns the row of a pair of materials, in any order. All values are zero if the pair was never set.
MaterialPair material_row(const scree_world* world, int a, int b);

// Returns whether a row differs from that of a pair of materials. Sets tiny values of the row to 0.
bool material_changes(const scree_world* world, int a, int b, MaterialPair* row);

// Sets the row of a pair of materials after material_changes, and marks it for the next upload.
scree_status material_set(scree_world* world, const char* function, int a, int b, MaterialPair row);

scree_status upload_materials(scree_world* world);
uint64_t materials_hash(const scree_world* world);
void materials_close(scree_world* world);

#endif
