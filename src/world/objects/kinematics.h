// SPDX-License-Identifier: MIT
// kinematics.h -- the list of a world's kinematic bodies.
#ifndef KINEMATICS_H
#define KINEMATICS_H
#include "scree/scree.h"

// Reserves memory for more kinematic bodies, after which kinematic_put cannot fail.
scree_status kinematics_reserve(scree_world* world, const char* function, int more);

// kinematic_put adds a body to the list; kinematic_drop removes a body if it is in the list.
void kinematic_put(scree_world* world, int body);
void kinematic_drop(scree_world* world, int body);

#endif
