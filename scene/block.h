// SPDX-License-Identifier: MIT
// block.h -- a block of a scene: like bodies, or collidables without a body, repeated over nested ranges.
#ifndef BLOCK_H
#define BLOCK_H
#include "scene/attributes.h"
#include "scene/reader.h"
#include "scene/scene.h"

#define MAX_LOOPS  4
#define BATCH_SIZE 65536

typedef struct // an index runs over the whole numbers from first up to, not including, end
{
	char index[NAME_SIZE];
	Number first, end;
} Loop;

typedef struct // which of a list of attributes
{
	int* attributes; // positions in Scene.attributes
	int count;
	Number choose; // when there is more than one
} Choice;

typedef struct // one collidable of each item
{
	Choice choice;
	Number position[2], angle;
	scree_filter filter;
} Part;

typedef struct // what happens to bodies of a block before every step; their numbers may be random, and know no index
{
	int moved, replaced; // bodies a step: put elsewhere, destroyed and made anew elsewhere
	Number position[2], velocity[2];
	Number angle, angular_velocity;
	scree_body_def* items; // all bodies of the block as they begin, attributes as in a Batch
} Churn;

struct Block
{
	bool bodies; // else collidables without a body: one part and no more
	scree_body_type type;
	uint32_t locks;
	Loop loops[MAX_LOOPS];
	int loop_count;
	Number position[2], velocity[2]; // m, m/s
	Number angle, angular_velocity;  // rad, rad/s
	Number gravity_scale, linear_damping, angular_damping;
	Part* parts;
	int part_count;
	bool simple;   // one part, at the body's origin
	int64_t count; // items
	Churn churn;
};

// Items on their way into a world. Attributes are positions in Scene.attributes, with generation 0.
typedef struct
{
	int count, capacity;         // items
	scree_body_def* bodies;      // count, or null
	scree_collidable_def* parts; // count * part_count, or null
	const Block* block;
	bool (*full)(void* context, const void* batch); // takes the items; null to drop them
	void* context;
} Batch;

// Reads one entry of "bodies" or "collidables".
bool block_read(Reader* reader, const Place* place, const json_t* value, const Scene* scene, bool bodies, Block* block);

// Counts the items into block->count; fails when there are more than limit.
bool block_count(Reader* reader, const Place* place, Block* block, int64_t limit);

// Evaluates all items, batch by batch. Fails when an item's number is bad (never the second time), when memory is short,
// or when full returns false.
bool block_walk(Reader* reader, const Block* block, bool (*full)(void* context, const void* batch), void* context);

// Where body number serial that churn puts somewhere begins, and how it moves there.
bool block_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body);

// Checks the churn of a block that has been counted, and keeps what is made anew.
bool churn_open(Reader* reader, const Place* place, Block* block);

void block_free(Block* block);

#endif
