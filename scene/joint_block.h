// SPDX-License-Identifier: MIT
// joint_block.h -- a block of joints of a scene: joints of one type, repeated over nested loops.
#ifndef JOINT_BLOCK_H
#define JOINT_BLOCK_H
#include "scene/format.h"
#include "scene/loop.h"

typedef struct // one of the two bodies of each joint
{
	int block;    // position in Scene.blocks; -1: the world
	Number index; // of the body in its block
} JointEnd;

struct JointBlock
{
	char path[NAME_SIZE]; // its location in the file, for errors
	Loops loops;
	JointEnd ends[2];    // a, b
	int on;              // position in Scene.paths, -1 for none
	scree_joint_def def; // what all items have in common
	FormatNumbers numbers;
	bool coupled;  // a gear or a pulley
	bool measured; // the target along is what the joint measures where the bodies are created
	bool
	    placed; // by anchors in the world, where the bodies are created, and the direction of the x axes of both frames
	Number anchors[2][2]; // m
	Number axis;          // rad
	int64_t count;        // items
};

// Reads one entry of "joints". The blocks of bodies have been read. The caller frees the block, also on failure.
bool joint_block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block);

// Reads the body at one end: null for the world, or a block of bodies by name and the index of a body in it. The caller frees the index.
bool joint_end_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, JointEnd* end);

void joint_block_free(JointBlock* block);

#endif
