// SPDX-License-Identifier: MIT
// make_joints.h -- creates joints for tests, and reads their state.
#ifndef MAKE_JOINTS_H
#define MAKE_JOINTS_H
#include "support/make_bodies.h"

static const scree_body NOBODY = {0, 0};

// CHAIN_LEAST or more joints in a row are a chain, which is solved together. The locks along and across of a chain are
// as stiff as other locks with CHAIN_STIFFER times their frequency. The locks of its angles are rigid.
#define CHAIN_LEAST   8
#define CHAIN_STIFFER 2.7173 // sqrt(4 (2 z + 4 h w) / (2 z + h w)); damping ratio z = 2, h = 1 / 240 s, w = 2 pi 60 / s

// Returns the definition of a joint between two bodies. Both frames of the joint are at the same pose in the world.
// Each body may be null.
scree_joint_def joint_def_at(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y,
                             float radians);
scree_joint add_joint(scree_world* world, const scree_joint_def* def);

// Adds a joint with the defaults of its type.
scree_joint join(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y);

// Measures the coordinate of a gear or a pulley at the current poses of its bodies, and adds the joint.
scree_joint couple(scree_world* world, scree_joint_def* def);

scree_joint_state joint_state_of(scree_world* world, scree_joint joint);
int joint_events_of(scree_world* world, scree_joint_event* events, int capacity);
int joints_of(scree_world* world);

// Returns the largest distance between the two anchors of a joint, over all joints that are not broken, m.
double joint_gap_of(scree_world* world);

#endif
