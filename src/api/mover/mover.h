// SPDX-License-Identifier: MIT
// mover.h -- declares the checks and the shape of movers that all calls with movers share.
#ifndef MOVER_H
#define MOVER_H
#include "scree/scree.h"

// Checks the arguments of a call with movers. def: may be null for the default. Copies the definition to *used, with
// the members that a definition of an older program lacks.
scree_status mover_check(scree_world* world, const char* function, const scree_mover* movers, int count, float dt,
                         const scree_mover_def* def, scree_mover_def* used);

// Returns the collidables that stop movers.
scree_query_def mover_query(const scree_mover_def* def);

// Computes the upright capsule of movers, or their circle, around the position of a mover.
scree_status mover_shape(const scree_mover_def* def, scree_shape* shape);

// Returns the cosine of the steepest slope that counts as ground.
float mover_steepest(const scree_mover_def* def);

#endif
