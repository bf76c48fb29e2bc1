// SPDX-License-Identifier: MIT
// bones.h -- a ragdoll of 11 bodies, with the measures of shared/human.c in Erin Catto's Box2D v3.
#ifndef BONES_H
#define BONES_H
#include "validation.h"

#define BONES      11
#define BONE_PARTS 2 // at most

// A bone of a ragdoll that stands at a place. Bones of one group (1 or more) do not touch each other.
scree_body_def bone_def(int bone, scree_vec feet, int group);

// Writes the collidables of a bone, and returns how many there are.
int bone_parts(int bone, int group, EnginePart parts[BONE_PARTS]);

// The bone that a joint connects with this one, which comes later; -1: none.
int bone_parent(int bone);

// The joint of a bone with its parent, which is body a.
scree_joint_def bone_joint(int bone);

#endif
