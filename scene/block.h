// SPDX-License-Identifier: MIT
// block.h -- a block of a scene: bodies of one kind, or collidables without a body, repeated over nested loops.
#ifndef BLOCK_H
#define BLOCK_H
#include "scene/loop.h"
#include "scene/part.h"

typedef struct // what happens to bodies of a block before every step; numbers may be random and use no index
{
	int moved, replaced; // bodies a step: moved to another place, destroyed and created again there
	Number position[2], velocity[2];
	Number angle, angular_velocity;
	scree_body_def* items; // all bodies of the block as created first; attributes: positions in Scene.attributes
} Churn;

struct Block
{
	char name[NAME_SIZE]; // of bodies, for joints; empty for none
	bool bodies;          // else collidables without a body, of one part
	scree_body_type type;
	uint32_t locks;
	Loops loops;
	Number position[2], velocity[2]; // m, m/s
	Number angle, angular_velocity;  // rad, rad/s
	Number gravity_scale, linear_damping, angular_damping;
	bool disabled;
	Parts parts;
	int64_t count;     // items
	scree_pose* poses; // of the bodies of a block with a name, as they are created
	Churn churn;
};

// Reads one entry of "bodies" or "collidables". The caller frees the block, also on failure.
bool block_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Block* block);

// The position in Scene.blocks of the bodies with a name, -1 when there are none.
int block_find(const Scene* scene, const char* name);

// The first body of a block among the bodies of the scene, in the order of the file.
int block_first(const Scene* scene, int block);

void block_free(Block* block);

#endif
