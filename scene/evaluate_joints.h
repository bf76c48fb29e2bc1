// SPDX-License-Identifier: MIT
// evaluate_joints.h -- computes the joints of a block as scree.h defines them.
#ifndef EVALUATE_JOINTS_H
#define EVALUATE_JOINTS_H
#include "scene/joint_block.h"

#define JOINT_BATCH 16384 // joints of a batch, at most

typedef struct
{
	int a, b; // index of the body in its block; 0 for the world
} JointEnds;

typedef struct // consecutive joints
{
	int count, capacity;
	scree_joint_def* defs; // bodies are null
	JointEnds* ends;
	const Scene* scene;
	const JointBlock* block;
	bool (*full)(void* context, const void* batch); // receives the joints; null to drop them
	void* context;
} JointBatch;

// Computes all joints, batch by batch. Fails as evaluate_block does, and when a joint has one body twice.
bool evaluate_joints(Reader* reader, const Scene* scene, const JointBlock* block,
                     bool (*full)(void* context, const void* batch), void* context);

#endif
