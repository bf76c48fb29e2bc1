// SPDX-License-Identifier: MIT
// box2d_joint.h -- adds a joint of Scree to a world of Box2D.
#ifndef BOX2D_JOINT_H
#define BOX2D_JOINT_H
#include "scree/scree.h"
#include <box2d/box2d.h>

// Adds a joint between two bodies. If Box2D has no joint of this type, prints a sentence and returns false.
bool box2d_add_joint(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b);

#endif
