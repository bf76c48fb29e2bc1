// SPDX-License-Identifier: MIT
// joint_block.h -- a block of joints of a scene: joints of one type, repeated over nested loops.
#ifndef JOINT_BLOCK_H
#define JOINT_BLOCK_H
#include "scene/loop.h"
#include "scene/scene.h"

#define MAX_JOINT_NUMBERS 42 // 6 of the joint and 12 of each coordinate: more than any entry can have

typedef struct // one of the two bodies of each joint
{
	int block;    // position in Scene.blocks; -1: the world
	Number index; // of the body in its block
} JointEnd;

typedef struct // a number of scree_joint_def that differs between items
{
	size_t offset; // of the float
	Number number;
} JointNumber;

struct JointBlock
{
	char path[NAME_SIZE]; // its location in the file, for errors
	Loops loops;
	JointEnd ends[2];    // a, b
	int on;              // position in Scene.paths, -1 for none
	scree_joint_def def; // what all items have in common
	JointNumber numbers[MAX_JOINT_NUMBERS];
	int number_count;
	// either anchors in the world, where the bodies are created, and the direction of the x axes of both frames
	bool placed, coupled, measured; // measured: the target along is the distance of the anchors
	Number anchors[2][2];           // m
	Number axis;                    // rad
	// or frames in the bodies
	Number positions[2][2]; // m
	Number angles[2];       // rad
	// bases of a gear or a pulley, in the world; measured: the target along is what it measures from them
	Number base_positions[2][2]; // m
	Number base_angles[2];       // rad
	int64_t count;               // items
};

// Reads one entry of "joints". The blocks of bodies have been read. The caller frees the block, also on failure.
bool joint_block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block);

// Reads the body at one end: null for the world, or a block of bodies by name and the index of a body in it. The caller frees the index.
bool joint_end_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, JointEnd* end);

void joint_block_free(JointBlock* block);

#endif
