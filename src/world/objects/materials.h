// SPDX-License-Identifier: MIT
// materials.h -- what pairs of materials do: the rows of the pool material_pair.
#ifndef MATERIALS_H
#define MATERIALS_H
#include "world/world.h"

// The row of a pair of materials, in any order; all zero for one that was never set.
MaterialPair material_row(const scree_world* world, int a, int b);

// Sets it. The next upload sends it.
scree_status material_set(scree_world* world, const char* function, int a, int b, MaterialPair row);

scree_status upload_materials(scree_world* world);
uint64_t materials_hash(const scree_world* world);
void materials_close(scree_world* world);

#endif
