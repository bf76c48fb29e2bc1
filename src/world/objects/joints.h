// SPDX-License-Identifier: MIT
// joints.h -- keeps the slots of joints and their lists by body, and uploads joints. An upload writes all data of a
// joint: the host has everything except whether the joint broke.
#ifndef JOINTS_H
#define JOINTS_H
#include "world/objects/joint_ends.h"

scree_status joints_reserve(scree_world* world, const char* function, int more);

// Records the anchors of a joint, which may raise the inertia of its bodies. Needs reserved memory for two commands.
void joint_anchors(scree_world* world, int index);

// Creates a joint, and returns its slot. The caller has reserved memory, and checked the definition.
int joint_put(scree_world* world, const scree_joint_def* def, int body_a, int body_b);
void joint_remove(scree_world* world, int index);

#define JOINT_COMMANDS 2 // maximum number of commands that a change of a joint records

// Returns the number of joints of a body.
int body_joint_count(const scree_world* world, int body);

// Returns a joint in the form for the device.
JointEdit joint_edit(const scree_world* world, int index);

// Marks a joint that the user changed for the upload, and wakes its bodies. The caller has reserved JOINT_COMMANDS
// commands. restarts: its constraint begins again, without impulses, and chains are found again.
void joint_changed(scree_world* world, int index, bool restarts);

// The same for a change that wakes no body.
void joint_resend(scree_world* world, int index);

// Restarts the joints of a body whose type has changed, or which was enabled or disabled.
void body_joints_changed(scree_world* world, int body);
void body_joints_remove(scree_world* world, int body);

// Makes a body's joints on paths search for the nearest part of the path again, after the body was placed elsewhere.
void body_joints_seek(scree_world* world, int body);

enum
{
	JOINT_TYPES = 0
#define X(NAME, name, locks) +1
#include "world/objects/joint_presets.def"
};

// Returns whether a type of joint is a gear or a pulley, which have only the coordinate SCREE_ALONG.
static inline bool joint_couples(scree_joint_type type)
{
	return type == SCREE_JOINT_GEAR || type == SCREE_JOINT_PULLEY;
}

// Uploads the pending joints. memory: space for one row per pending joint.
scree_status upload_joints(scree_world* world, void* memory);

#endif
