// SPDX-License-Identifier: MIT
// bones.h -- defines a ragdoll of 11 bodies, with the dimensions of shared/human.c in Erin Catto's Box2D v3.
#ifndef BONES_H
#define BONES_H
#include "validation.h"

#define BONES      11
#define BONE_PARTS 2 // maximum number of collidables of a bone

// Returns the body definition of a bone of a ragdoll whose feet are at the point `feet`. Bones of one group (1 or more)
// do not touch each other.
scree_body_def bone_def(int bone, scree_vec feet, int group);

// Writes the collidables of a bone. Returns the number of collidables.
int bone_parts(int bone, int group, EnginePart parts[BONE_PARTS]);

// Returns the parent of a bone, to which a joint connects the bone; -1: no parent. Parents have smaller indices than
// their children.
int bone_parent(int bone);

// Returns the joint between a bone (body b) and its parent (body a).
scree_joint_def bone_joint(int bone);

#endif
