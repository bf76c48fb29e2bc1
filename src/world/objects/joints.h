// SPDX-License-Identifier: MIT
// joints.h -- slots of joints, their lists by body, and the upload.
//
// The host has all data of a joint except whether it broke, so an upload sends its whole row.
#ifndef JOINTS_H
#define JOINTS_H
#include "world/objects/joint_ends.h"

scree_status joints_reserve(scree_world* world, const char* function, int more);

// Records the anchors of a joint at its bodies. The caller has reserved memory for two commands.
void joint_anchors(scree_world* world, int index);

// Creates a joint in a slot, for which memory is reserved. The definition is checked.
int joint_put(scree_world* world, const scree_joint_def* def, int body_a, int body_b);
void joint_remove(scree_world* world, int index);

// Marks a joint for the upload; restarts: its constraint begins again, without impulses.
void joint_changed(scree_world* world, int index, bool restarts);

// Restarts the joints of a body that became movable or immovable.
void body_joints_changed(scree_world* world, int body);
void body_joints_remove(scree_world* world, int body);

// Lets the joints on paths of a body search for the nearest part of their paths, because the body was placed elsewhere.
void body_joints_seek(scree_world* world, int body);

enum
{
	JOINT_TYPES = 0
#define X(NAME, name, locks) +1
#include "world/objects/joint_presets.def"
};

// Returns whether a joint is a gear or a pulley, which has only the coordinate along.
static inline bool joint_couples(scree_joint_type type)
{
	return type == SCREE_JOINT_GEAR || type == SCREE_JOINT_PULLEY;
}

// Sends the pending joints. memory has space for one row per joint.
scree_status upload_joints(scree_world* world, void* memory);

#endif
