// SPDX-License-Identifier: MIT
// joints.h -- slots of joints, their lists by body, and what waits for the upload.
//
// The host has all of a joint but whether it broke, so what is uploaded is its whole row.
#ifndef JOINTS_H
#define JOINTS_H
#include "world/objects/joint_ends.h"

scree_status joints_reserve(scree_world* world, const char* function, int more);

// Notes the anchors of a joint at its bodies. The caller has reserved room for two commands.
void joint_anchors(scree_world* world, int index);

// Takes a slot, for which room is reserved. The definition is checked.
int joint_put(scree_world* world, const scree_joint_def* def, int body_a, int body_b);
void joint_remove(scree_world* world, int index);

// A joint waits for the upload; restarts: its constraint starts anew.
void joint_changed(scree_world* world, int index, bool restarts);

// The joints of a body start anew: it can move now, or no longer.
void body_joints_changed(scree_world* world, int body);
void body_joints_remove(scree_world* world, int body);

// The joints on paths of a body look for the nearest part of their paths: it was placed elsewhere.
void body_joints_seek(scree_world* world, int body);

#define JOINT_TYPES (SCREE_JOINT_PATH + 1)

// Whether a joint is a gear or a pulley, whose one coordinate is that along.
static inline bool joint_couples(scree_joint_type type)
{
	return type == SCREE_JOINT_GEAR || type == SCREE_JOINT_PULLEY;
}

// Sends the joints that wait. memory has room for as many rows.
scree_status upload_joints(scree_world* world, void* memory);

#endif
