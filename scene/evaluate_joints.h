// SPDX-License-Identifier: MIT
// evaluate_joints.h -- computes the joints of a block, as definitions of scree.h.
#ifndef EVALUATE_JOINTS_H
#define EVALUATE_JOINTS_H
#include "scene/joint_block.h"

#define JOINT_BATCH 16384 // maximum number of joints of a batch

typedef struct
{
	int a, b; // indices of the two bodies in their blocks; 0 for the world
} JointEnds;

typedef struct // consecutive joints of a block
{
	int count, capacity;
	scree_joint_def* defs; // definitions without bodies, whose handles are set later
	JointEnds* ends;
	const Scene* scene;
	const JointBlock* block;
	bool (*full)(void* context, const void* batch); // function that receives a full batch; null: the joints are dropped
	void* context;
} JointBatch;

// Computes all joints, batch by batch. Fails for the same reasons as evaluate_block, and if bodies a and b of a joint
// are the same.
bool evaluate_joints(Reader* reader, const Scene* scene, const JointBlock* block,
                     bool (*full)(void* context, const void* batch), void* context);

#endif
