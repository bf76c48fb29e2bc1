// SPDX-License-Identifier: MIT
// make_joints.h -- joints of tests, and reads of their state.
#ifndef MAKE_JOINTS_H
#define MAKE_JOINTS_H
#include "support/make_bodies.h"

static const scree_body NOBODY = {0, 0};

// At least CHAIN_LEAST joints in a row are solved together. Their translations are as stiff as at CHAIN_STIFFER times
// the frequency; their angles are rigid.
#define CHAIN_LEAST   8
#define CHAIN_STIFFER 2.7173 // sqrt(4 (2 z + 4 h w) / (2 z + h w)) at 60 Hz, ratio z = 2, h = 1 / 240 s

// Returns the definition of a joint between two bodies with both frames at a pose in the world. Either body may be
// null.
scree_joint_def joint_def_at(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y,
                             float radians);
scree_joint add_joint(scree_world* world, const scree_joint_def* def);

// Adds a joint with the defaults of its type.
scree_joint join(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y);

// Measures a gear or a pulley at the current poses of its bodies, and adds it.
scree_joint couple(scree_world* world, scree_joint_def* def);

scree_joint_state joint_state_of(scree_world* world, scree_joint joint);
int joint_events_of(scree_world* world, scree_joint_event* events, int capacity);
int joints_of(scree_world* world);

// Returns the largest gap, along or across, of all joints that are not broken, m.
double joint_gap_of(scree_world* world);

#endif
