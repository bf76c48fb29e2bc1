// SPDX-License-Identifier: MIT
// block.h -- a block of a scene: bodies of one kind, or collidables without a body, repeated over nested loops.
#ifndef BLOCK_H
#define BLOCK_H
#include "scene/loop.h"
#include "scene/part.h"

struct Block
{
	char name[NAME_SIZE]; // name of the bodies, for joints; empty if they have none
	bool bodies;          // if false: collidables without a body, of one part
	Loops loops;
	scree_body_def def; // values that all bodies have in common
	FormatNumbers numbers;
	Parts parts;
	int64_t count;     // number of items
	scree_pose* poses; // poses of the bodies of a block with a name, as they are created
	Churn churn;
	FormatNumbers churn_numbers; // numbers that use no index
};

// Reads one entry of "bodies" or "collidables". The caller frees the block, also on failure.
bool block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Block* block);

// Returns the position in Scene.blocks of the bodies with a name, -1 if there are none.
int block_find(const Scene* scene, const char* name);

// Reads the name of bodies, and stores their position in Scene.blocks.
bool block_read_name(Reader* reader, const Location* location, const json_t* value, const Scene* scene, int* block);

// Returns the index of a block's first body among the bodies of the scene, in the order of the file.
int block_first(const Scene* scene, int block);

void block_free(Block* block);

#endif
