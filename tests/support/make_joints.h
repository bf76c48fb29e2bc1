// SPDX-License-Identifier: MIT
// make_joints.h -- joints of tests: made and read.
#ifndef MAKE_JOINTS_H
#define MAKE_JOINTS_H
#include "support/make_bodies.h"

static const scree_body NOBODY = {0, 0};

// A row of this many joints or more is solved together, and its translations are as stiff as at this many times the frequency;
// angles are rigid.
#define CHAIN_LEAST   8
#define CHAIN_STIFFER 2.7173 // sqrt(4 (2 z + 4 h w) / (2 z + h w)) at 60 Hz, ratio z = 2, h = 1 / 240 s

// A definition between two bodies, whose frames lie at a pose in the world; either body may be null.
scree_joint_def joint_def_at(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y,
                             float radians);
scree_joint add_joint(scree_world* world, const scree_joint_def* def);

// A joint with the defaults of its type.
scree_joint join(scree_world* world, scree_joint_type type, scree_body a, scree_body b, float x, float y);

// Lets the joint measure from where its bodies are now, and adds it: gears and pulleys.
scree_joint couple(scree_world* world, scree_joint_def* def);

scree_joint_state joint_state_of(scree_world* world, scree_joint joint);
int joint_events_of(scree_world* world, scree_joint_event* events, int capacity);
int joints_of(scree_world* world);

// The largest gap, along or across, of all joints that are not broken, m.
double joint_gap_of(scree_world* world);

#endif
