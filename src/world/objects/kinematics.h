// SPDX-License-Identifier: MIT
// kinematics.h -- keeps the list of kinematic bodies.
#ifndef KINEMATICS_H
#define KINEMATICS_H
#include "scree/scree.h"

// Reserves memory for more kinematic bodies, so that kinematic_put cannot fail.
scree_status kinematics_reserve(scree_world* world, const char* function, int more);

// kinematic_put adds a body to the list. kinematic_drop removes a body; it does nothing if the body is not in the list.
void kinematic_put(scree_world* world, int body);
void kinematic_drop(scree_world* world, int body);

#endif
