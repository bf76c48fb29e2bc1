// SPDX-License-Identifier: MIT
// joint_block.h -- a block of joints of a scene: joints of one type, repeated over nested loops.
#ifndef JOINT_BLOCK_H
#define JOINT_BLOCK_H
#include "scene/format.h"
#include "scene/loop.h"

typedef struct // one of the two bodies of each joint
{
	int block;    // position in Scene.blocks; -1: the world
	Number index; // index of the body in its block
} JointEnd;

struct JointBlock
{
	char path[NAME_SIZE]; // its location in the file, for errors
	Loops loops;
	JointEnd ends[2];    // a, b
	int on;              // position in Scene.paths, -1 for none
	scree_joint_def def; // values that all items have in common
	FormatNumbers numbers;
	bool coupled;  // true for a gear or a pulley
	bool measured; // true if the target along is its value at the initial poses of the bodies
	// true if the joint has anchors in the world, at the initial poses of the bodies, and a direction of the x axes of
	// both frames
	bool placed;
	Number anchors[2][2]; // m
	Number axis;          // rad
	int64_t count;        // number of items
};

// Reads one entry of "joints". The blocks of bodies have been read. The caller frees the block, also on failure.
bool joint_block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block);

// Reads the body at one end: null for the world, or the name of a block of bodies and the index of a body in it. The
// caller frees the index.
bool joint_end_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, JointEnd* end);

void joint_block_free(JointBlock* block);

#endif
