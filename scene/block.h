// SPDX-License-Identifier: MIT
// block.h -- reads a block of a scene: bodies of one kind, or collidables without a body, repeated over nested loops.
#ifndef BLOCK_H
#define BLOCK_H
#include "scene/loop.h"
#include "scene/part.h"

struct Block
{
	char name[NAME_SIZE]; // name for references to the bodies; empty if they have no name
	bool bodies;          // false: collidables without a body, each of one part
	Loops loops;
	scree_body_def def; // values that all bodies have in common
	FormatNumbers numbers;
	Parts parts;
	int64_t count;     // number of items
	scree_pose* poses; // initial poses of the bodies; null if the block has no name
	bool centered;     // true: velocities are those of the centers of mass, also with collidables or a mass
	bool massed;       // true: the bodies have a mass that the file sets
	scree_mass mass;   // values that all bodies have in common
	FormatNumbers mass_numbers;
	Churn churn;
	FormatNumbers churn_numbers; // numbers of churn; their expressions contain no loop index
};

// Reads one entry of "bodies" or "collidables". The caller frees the block, also on failure.
bool block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Block* block);

// Reads a text that must be the name of a block of bodies, and sets *block to its position in Scene.blocks.
bool block_read_name(Reader* reader, const Location* location, const json_t* value, const Scene* scene, int* block);

// Returns the index of a block's first body among the bodies of the scene, in the order of the file.
int block_first(const Scene* scene, int block);

void block_free(Block* block);

#endif
