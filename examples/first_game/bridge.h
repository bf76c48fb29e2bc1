// SPDX-License-Identifier: MIT
// bridge.h -- the bridge of the first game: planks that hang on each other by hinges.
#ifndef BRIDGE_H
#define BRIDGE_H
#include <scree/scree_math.h>

#define COLOR_PLANK   0xa07850c0u
#define BRIDGE_PLANKS 12

// Adds a bridge that begins at x, m. Returns the x of its other end.
static inline float bridge_create(scree_world* world, float x)
{
	scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_vec end = {x + 0.1f, -0.1f};
	for (int k = 0; k < BRIDGE_PLANKS; ++k)
	{
		// planks of 0.8 m, each turned a little more than the one before, so that the bridge sags
		scree_pose pose = scree_pose_make(0.0f, 0.0f, 0.3f * (2.0f * (float)k + 1.0f - BRIDGE_PLANKS) / BRIDGE_PLANKS);
		pose.position = scree_vec_add(end, scree_rot_apply(pose.rotation, scree_vec_make(0.4f, 0.0f)));
		hinge.body_a = hinge.body_b; // the plank before; null for the first one: its hinge is in the world
		scree_body_create_box(world, SCREE_BODY_DYNAMIC, pose, 0.38f, 0.1f, COLOR_PLANK, &hinge.body_b);
		scree_joint_def_place(world, &hinge, scree_pose_make(end.x, end.y, 0.0f));
		scree_joint_create(world, &hinge, NULL);
		end = scree_pose_apply(pose, scree_vec_make(0.4f, 0.0f));
	}
	hinge.body_a = SCREE_NULL_BODY;
	scree_joint_def_place(world, &hinge, scree_pose_make(end.x, end.y, 0.0f));
	scree_joint_create(world, &hinge, NULL);
	return end.x + 0.1f;
}

#endif
