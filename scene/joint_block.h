// SPDX-License-Identifier: MIT
// joint_block.h -- reads a block of joints of a scene: joints of one type, repeated over nested loops.
#ifndef JOINT_BLOCK_H
#define JOINT_BLOCK_H
#include "scene/format.h"
#include "scene/loop.h"

typedef struct // body of one end of the joints
{
	int block;    // position in Scene.blocks; -1: the world
	Number index; // index of the body in its block
} JointEnd;

struct JointBlock
{
	char path[NAME_SIZE]; // location in the file, for errors
	Loops loops;
	JointEnd ends[2];    // ends at body a and body b
	int on;              // position in Scene.paths; -1: not on a path
	scree_joint_def def; // values that all items have in common
	FormatNumbers numbers;
	bool coupled;   // true for a gear or a pulley
	bool turned[2]; // gear or pulley: true if the file gives the initial angle of the side
	bool measured;  // true if the target is the value of the coordinate `along` at the initial poses
	// true if the file gives anchors in the world, at the initial poses, and a direction of the x axes of both frames
	bool placed;
	Number anchors[2][2]; // m: x and y of both anchors, in the world
	Number axis;          // rad: direction of the x axes, in the world
	int64_t count;        // number of joints
};

// Reads one entry of "joints", after the blocks of bodies. The caller frees the block, also on failure.
bool joint_block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                      JointBlock* block);

// Reads the body of one end: null for the world, or an object with the name of a block of bodies and the index of a
// body in it. The caller frees end->index.
bool joint_end_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, JointEnd* end);

void joint_block_free(JointBlock* block);

#endif
